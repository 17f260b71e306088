/* input.c - a file in pieces of bounded size: bytes, lines, words.
   SPDX-License-Identifier: GPL-3.0-or-later

   Invariant: data[end] is NUL, so that whoever reads text stops there without counting. A line that
   was taken ends with a NUL in place of its newline. */
#include "mesh.h"

#include <string.h>

size_t mesh_input_fill(struct mesh_input *in, size_t want) {
  if (in->end - in->at >= want || in->ended)
    return in->end - in->at;
  memmove(in->data, in->data + in->at, in->end - in->at);
  in->offset += in->at;
  in->end -= in->at;
  in->at = 0;
  while (in->end < want && !in->ended) {
    const size_t got = fread(in->data + in->end, 1, MESH_BUFFER - in->end, in->file);
    in->end += got;
    if (got == 0) {
      in->ended = 1;
      in->failed = ferror(in->file);
    }
  }
  in->data[in->end] = '\0';
  return in->end;
}

void mesh_input_mark(struct mesh_input *in) {
  static const unsigned char mark[] = {0xef, 0xbb, 0xbf};
  if (mesh_input_fill(in, sizeof mark) >= sizeof mark &&
      memcmp(in->data + in->at, mark, sizeof mark) == 0)
    in->at += sizeof mark;
}

int mesh_input_skip(struct mesh_input *in, uint64_t n) {
  while (n > 0) {
    const size_t have = mesh_input_fill(in, 1);
    const size_t step = have < n ? have : (size_t)n;
    if (have == 0)
      return -1;
    in->at += step;
    n -= step;
  }
  return 0;
}

/* The newline that ends the line at in->at, from `from` bytes on; NULL: not in the buffer. */
static unsigned char *find_end(struct mesh_input *in, size_t from, int join) {
  unsigned char *start = in->data + in->at, *end = start + from;
  while ((end = memchr(end, '\n', (size_t)(in->data + in->end - end))) != NULL) {
    unsigned char *last = end;
    if (last > start && last[-1] == '\r')
      last--;
    if (!join || last == start || last[-1] != '\\')
      return end;
    last[-1] = *end = ' ';
    in->line++;
  }
  return NULL;
}

int mesh_input_line(struct mesh_input *in, int join, char **begin, char **end) {
  unsigned char *newline = find_end(in, 0, join);
  if (newline == NULL) {
    const size_t seen = in->end - in->at;
    size_t have = seen;
    if (seen < MESH_BUFFER && !in->ended)
      have = mesh_input_fill(in, MESH_BUFFER);
    if (have == 0)
      return 0;
    newline = find_end(in, seen, join);
    if (newline == NULL && have == MESH_BUFFER)
      return -1;
    if (newline == NULL)
      newline = in->data + in->end; /* the last line has no newline */
  }
  *begin = (char *)in->data + in->at;
  *end = (char *)newline;
  in->at = (size_t)(newline - in->data) + (newline < in->data + in->end);
  in->line++;
  if (memchr(*begin, '\0', (size_t)(*end - *begin)) != NULL)
    return -1;
  *newline = '\0';
  return 1;
}

int mesh_word_is(const char *s, const char *end, const char *name) {
  for (; s < end && *name != '\0'; s++, name++) {
    const char c = *s >= 'A' && *s <= 'Z' ? (char)(*s - 'A' + 'a') : *s;
    if (c != *name)
      return 0;
  }
  return s == end && *name == '\0';
}
