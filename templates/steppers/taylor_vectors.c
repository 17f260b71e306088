%% -- taylor_vectors.c -- vectors of a host for the Taylor series: part of scene.c.  SPDX-License-Identifier: MIT-0
/* Rows of vectors for a host: compile with -D${upper}_VECTOR and -march=native; the same recurrences, summed in another order. */
#if defined ${upper}_VECTOR && \
  (defined __clang__ || (defined __GNUC__ && __GNUC__ >= 12)) && \
  (defined __AVX512F__ || (defined __AVX__ && (defined __clang__ || ${float})))
#define ${upper}_PACKED
#endif

#if defined ${upper}_PACKED
typedef ${name}_real ${name}_pack __attribute__((vector_size(${upper}_ROW*sizeof(${name}_real))));
typedef ${name}_real ${name}_row __attribute__((vector_size(${upper}_ROW*sizeof(${name}_real)), aligned(sizeof(${name}_real)), may_alias));

%% for _, text in ipairs(terms) do
${text}
%% end
#endif
