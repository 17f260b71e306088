/* mesh.h - what the mesh*.c files share: input in bounded pieces, welded vertices, running sums.
   SPDX-License-Identifier: GPL-3.0-or-later

   Flow: a reader (stl.c, obj.c, ply.c) takes the file through mesh_input and hands
   faces to mesh_build (mesh.c), which collects them in a batch. A full batch is welded
   (weld.c), added to the sums (sum.c), and only the three vertex numbers of each
   triangle are kept. At the end near.c welds what is near, if asked, topology.c looks at the
   edges, and parts.c at how the parts lie (with tree.c). Every array grows with the data
   that has arrived; no count in a file is believed beforehand. */
#ifndef MESH_H
#define MESH_H

#include <stdint.h>
#include <stdio.h>

#include "numbers/wide.h"

/* ---- input (input.c) ---- */

#ifndef MESH_BYTES /* the fuzz targets have less, for more boundaries */
#define MESH_BYTES (1 << 20)
#endif
enum { MESH_BUFFER = MESH_BYTES }; /* bytes; also the longest line of text */

struct mesh_input {
  FILE *file;
  unsigned char *data; /* MESH_BUFFER bytes and a NUL after the last valid one */
  size_t at, end;      /* what is not taken yet: data[at] ... data[end - 1] */
  uint64_t offset;     /* of data[0] in the file */
  uint64_t line;       /* number of the line that was taken last, from 1 */
  int64_t size;        /* of the file, -1 if it cannot be told */
  int ended, failed;   /* no more bytes; reading failed */
};

/* Make `want` bytes (at most MESH_BUFFER) available if the file has them: how many there are. */
size_t mesh_input_fill(struct mesh_input *in, size_t want);
/* Pass over UTF-8's mark of byte order (bytes EF BB BF), which some editors put first. */
void mesh_input_mark(struct mesh_input *in);
/* Pass over n bytes: 0, or -1 if the file ends before. */
int mesh_input_skip(struct mesh_input *in, uint64_t n);
/* Take a line: 1 with [*begin, *end), which is followed by a NUL; 0 at the end of the file; -1 when
   it does not fit or has a NUL in it. join: a backslash before the line's end makes the next line a
   part of it. */
int mesh_input_line(struct mesh_input *in, int join, char **begin, char **end);

static inline uint64_t mesh_input_tell(const struct mesh_input *in) {
  return in->offset + in->at;
}

static inline char *mesh_blank(char *s) { /* past blanks of a line */
  while (*s == ' ' || (*s >= '\t' && *s <= '\r'))
    s++;
  return s;
}

static inline char *mesh_word(char *s) { /* past a word */
  while (*s != '\0' && *s != ' ' && !(*s >= '\t' && *s <= '\r'))
    s++;
  return s;
}

/* Does the word [s, end) read `name` (lower case), in any case? */
int mesh_word_is(const char *s, const char *end, const char *name);

/* A decimal number at s, correctly rounded (number.c). The text must end with a NUL. The
   place behind it, or NULL when there is none. inf, infinity and nan are numbers too. */
char *mesh_number(char *s, double *value);

/* ---- welded vertices (weld.c) ---- */

#define MESH_NONE UINT32_MAX          /* no vertex */
#define MESH_MAX  (UINT32_C(1) << 31) /* vertices; edges need 31 bits a number */

struct mesh_points {
  double *xyz; /* three numbers each, in the order of their first use; no -0 */
  size_t count, capacity;
  uint64_t *slot; /* open addressing: high half of the hash, number + 1; 0: free */
  size_t mask;    /* slots - 1; at least half of them are free */
  double lo[3], hi[3];
};

uint64_t mesh_points_hash(const double p[3]);
/* Hints: the slot of a hash, and then the coordinates of the vertex in it. */
static inline void mesh_points_fetch_slot(const struct mesh_points *v, uint64_t hash) {
#if defined(__GNUC__)
  if (v->slot != NULL)
    __builtin_prefetch(&v->slot[(size_t)hash & v->mask]);
#else
  (void)v, (void)hash;
#endif
}
static inline void mesh_points_fetch_vertex(const struct mesh_points *v, uint64_t hash) {
#if defined(__GNUC__)
  const uint32_t id = v->slot != NULL ? (uint32_t)v->slot[(size_t)hash & v->mask] : 0;
  if (id != 0)
    __builtin_prefetch(v->xyz + 3 * (size_t)(id - 1));
#else
  (void)v, (void)hash;
#endif
}
/* The number of the vertex at p (finite, no -0), added when it is new; MESH_NONE: out of memory. */
uint32_t mesh_points_weld(struct mesh_points *v, const double p[3], uint64_t hash);

/* ---- sums (sum.c) ---- */

enum { MESH_BATCH = 256, MESH_TERMS = 11 };

/* Terms: w, w s, w Q, and the size of what was added to make the w's; see sum.c. */
struct mesh_sum {
  double origin[3]; /* local: the first vertex that is used */
  int begun;
  ph_wide head[MESH_TERMS], tail[MESH_TERMS];
};

struct mesh_batch {
  int count;
  double p[MESH_BATCH][9];
  uint32_t id[MESH_BATCH][3];
  signed char sign[MESH_BATCH];  /* of the area: -1 for the reflex part of a fan */
  unsigned char fan[MESH_BATCH]; /* part of a polygon: being flat alone is no defect */
};

void mesh_sum_volume(struct mesh_sum *sum, struct mesh_batch *batch);
void mesh_sum_surface(struct mesh_sum *sum, struct mesh_batch *batch);
/* Has the triangle no area, as far as rounding can tell? */
int mesh_flat(const double p[9]);
/* Twice the vector area of the triangle. */
void mesh_normal(const double p[9], ph_wide n[3]);
void mesh_sum_segment(struct mesh_sum *sum, const double p[6], ph_wide block[MESH_TERMS]);
void mesh_sum_block(struct mesh_sum *sum, const ph_wide block[MESH_TERMS]);

/* ---- the mesh that is read ---- */

struct mesh_list { /* of vertex numbers */
  uint32_t *item;
  size_t count, capacity;
};

#define MESH_DIAGONAL (UINT32_C(1) << 31)

struct mesh_build {
  ph_mesh result;
  struct mesh_points points;
  struct mesh_list corner;  /* three a triangle; MESH_DIAGONAL: the edge to the next is a fan's */
  struct mesh_list segment; /* two a segment */
  struct mesh_sum sum;
  struct mesh_batch batch;
  /* indexed formats: the file's vertices and their welded numbers once used */
  double *vertex;
  uint32_t *welded;
  size_t vertex_count, vertex_capacity;
  uint32_t *part;           /* of each triangle: the number of its part; of a volume that closes */
  signed char *turn;        /* of each part: -1 if it was turned, as its place demands; or NULL */
  double weld;              /* vertices nearer than this, in parts of the box, are one; 0: equal */
  struct mesh_list polygon; /* of the face that is being read: indices into vertex */
  struct mesh_input in;
  char *message;
  size_t message_size;
};

/* Write the message, return the status. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
int mesh_fail(struct mesh_build *b, int status, const char *format, ...);
int mesh_fail_memory(struct mesh_build *b);
/* The file ended, or failed, in the midst of `what`. */
int mesh_fail_end(struct mesh_build *b, const char *what);
/* A line that mesh_input_line cannot take. */
int mesh_fail_line(struct mesh_build *b);

/* A triangle by its coordinates. */
int mesh_add_triangle(struct mesh_build *b, const double p[9]);
/* A vertex of an indexed format. */
int mesh_add_vertex(struct mesh_build *b, const double p[3]);
/* The face whose corners are in b->polygon, at least three; a segment between two vertices. */
int mesh_add_polygon(struct mesh_build *b);
int mesh_add_segment(struct mesh_build *b, uint32_t from, uint32_t to);
/* What is in the batch: welded, summed, remembered. */
int mesh_flush(struct mesh_build *b);
int mesh_list_push(struct mesh_build *b, struct mesh_list *list, uint32_t item);

/* Readers: PH_OK or a status with the message written. The first bytes are in the buffer. */
int mesh_read_stl(struct mesh_build *b);
int mesh_read_obj(struct mesh_build *b);
int mesh_read_ply(struct mesh_build *b);

/* Edges, duplicates; for PH_MESH_WIRES the sums too; of a volume that closes the parts, numbered
   by their first triangles. PH_OK or PH_EMEMORY. */
int mesh_topology(struct mesh_build *b);

/* ---- vertices that are near (near.c) ---- */

/* Weld vertices nearer than b->weld times the box's longest side: numbers of corners change,
   triangles and segments that vanish are left out. */
int mesh_near(struct mesh_build *b);
/* Of a volume that is open: the least of 1e-9, 1e-8 .. 1e-3 that would close it, into
   result.weld. */
int mesh_near_offer(struct mesh_build *b);
/* The sums of a volume once more, from the triangles that are kept, with the parts' turns. */
void mesh_sum_again(struct mesh_build *b);

/* ---- triangles in a tree of boxes (tree.c) ---- */

struct mesh_tree {
  const double *xyz;      /* vertices, three numbers each */
  const uint32_t *corner; /* three a triangle, with MESH_DIAGONAL */
  uint32_t *order;        /* the tree's triangles, near ones together */
  size_t count;
  int depth;   /* nodes k have the children 2k + 1, 2k + 2 down to it */
  double *box; /* of each node: lowest and highest corner */
};

/* Of the n triangles in list (NULL: the first n). PH_OK or PH_EMEMORY. */
int mesh_tree_make(struct mesh_tree *tree, const double *xyz, const uint32_t *corner,
                   const uint32_t *list, size_t n);
void mesh_tree_free(struct mesh_tree *tree);
const double *mesh_tree_corner(const struct mesh_tree *tree, uint32_t triangle, int k);
/* The distance from p to the nearest triangle, `most` if none is nearer. */
double mesh_tree_distance(const struct mesh_tree *tree, const double p[3], double most);
/* How often the triangles wind about p: 1 inside of one closed surface that looks outward. turn:
   of each part (NULL: none) the side that counts. */
int mesh_tree_winding(const struct mesh_tree *tree, const double p[3], const uint32_t *part,
                      const signed char *turn);

/* ---- parts (parts.c) ---- */

/* How the parts of a volume lie: turns those that look to the wrong side for their place, names
   what overlaps. PH_OK or PH_EMEMORY. */
int mesh_parts(struct mesh_build *b);

/* ---- the faces, kept (faces.c) ---- */

/* Takes points, corners, parts and turns out of b; NULL: out of memory. */
ph_mesh_shape *mesh_shape(struct mesh_build *b);

#endif
