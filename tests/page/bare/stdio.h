/* stdio.h -- the one function of it that an emitted self-test calls, for WebAssembly without a C
 * library: a format without its values goes to the page, which counts the lines.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef POLHODE_BARE_STDIO_H
#define POLHODE_BARE_STDIO_H

#include <stdarg.h>

/* said(format, word): word is the first string among the values, or "". */
__attribute__((import_module("page"), import_name("said"))) void said(const char *format,
                                                                      const char *word);

static inline int printf(const char *format, ...) {
  const char *word = "";
  va_list values;

  va_start(values, format);
  if (format[0] == '%' && format[1] == 's')
    word = va_arg(values, const char *);
  va_end(values);
  said(format, word);
  return 0;
}

#endif
