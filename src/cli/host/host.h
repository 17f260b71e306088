/* host.h - what the parts of the program polhode share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The generator, written in Lua, opens no file and starts no process: it is handed one table
 * `host`, and each function of that table is a C function declared below with its Lua signature.
 * Convention of all of them: what can go wrong outside (files, compilers, numbers) returns nil and
 * a message; what only a bug of the caller can cause raises an error.
 */
#ifndef POLHODE_HOST_H
#define POLHODE_HOST_H

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>
#include <sys/types.h>

/* Scenes, XML: files beyond this size are refused. (Meshes are read elsewhere.) */
#define HOST_MAX_FILE ((size_t)4 << 20)

/* Exit status for "cannot write standard output"; 0 1 2 3 70 are the generator's. EX_IOERR of
 * sysexits. */
#define HOST_EXIT_OUTPUT 74
#define HOST_EXIT_BUG    70

/* Push the table `host`. */
void host_push(lua_State *L);

/* ---- sandbox/memory.c: Lua's allocator counts, and refuses beyond a limit ---- */

/* All that the program may use for Lua: a scene whose algebra explodes ends in an error. */
#define ACCOUNT_LIMIT ((size_t)1 << 30)

enum { ACCOUNT_LARGEST = 512, ACCOUNT_GRAIN = 16 }; /* bytes: pooled blocks, their steps */
struct account {
  size_t used, limit;
  size_t total, mark;    /* of all blocks there were; where `passed` is called */
  int asked;             /* the last request failed */
  void (*refused)(void); /* a request failed for good */
  void (*passed)(void);  /* total >= mark */
  void *free[ACCOUNT_LARGEST / ACCOUNT_GRAIN + 1]; /* lists of blocks by size in grains */
  char *next;                                      /* of the last chunk: what is not cut yet */
  size_t left;
  size_t pooled; /* blocks of at most so many bytes come from the pool */
};
/* Zero but for the limit; sets `pooled`. */
void account_open(struct account *a);
/* lua_Alloc with a struct account as user data. */
void *account_allocate(void *account, void *block, size_t old_size, size_t new_size);
struct account *account_of(lua_State *L);

/* ---- sandbox/interrupt.c: SIGINT, SIGTERM, SIGHUP become a Lua error, so that everything is
 * cleaned up
 * ---- */

void interrupt_watch(lua_State *L);
/* The signal that came, 0 if none; long loops in C ask now and then. */
int interrupt_pending(void);
/* Raise "interrupted", and at every instruction from then on, when a signal has come. */
void interrupt_check(lua_State *L);
/* Die of the signal that came, as the caller of the program expects. */
void interrupt_resume(void);

/* ---- files ---- */

/* A regular file, open to be read, and its size; -1 and why not. */
int host_open_file(const char *path, off_t *size, const char **why);
/* Push the file's text and return 1, or push nil and a message and return 2. */
int host_read_file(lua_State *L, const char *path);
/* Push the sorted names in a directory that end in `suffix`, return 1; or nil, message, 2. */
int host_list_directory(lua_State *L, const char *path, const char *suffix);

/* read(path) -> text | nil, message.  Regular files only; "-" is standard input. */
int host_read(lua_State *L);
/* bodies() -> the folder of the scenes that go by name | nil: POLHODE_BODIES; beside the program
   ../share/polhode/bodies (installed) or ../bodies (built in its sources); else ./bodies */
int host_bodies(lua_State *L);
/* within(folder, path) -> is it below the folder, all links followed? */
int host_within(lua_State *L);
/* sha256(text[, path...]) -> hexadecimal digits | nil, message.  Of the text and then of the files'
 * bytes, as `cat` would join them; regular files of any size. */
int host_sha256(lua_State *L);
/* list_dir(path, suffix) -> {names} | nil, message.  Sorted by byte; names that begin with a dot
 * are left out. */
int host_list_dir(lua_State *L);
/* write_files(dir, {{name=, text=}, ...}) -> true, {names written} | nil, message, exit status (74:
 the disk is full or broken, else 2).  All or nothing.
 * text = false: a file that is removed, and the folders that this leaves empty; it is among the
 * names if it was there. */
int host_write_files(lua_State *L);
/* write_file(path, text) -> true | nil, message, exit status: as write_files */
int host_write_file(lua_State *L);
/* tempdir() -> path | nil, message.  A new private directory, removed with its content at exit. */
int host_tempdir(lua_State *L);
void tempdir_remove_all(void);
int tempdir_holds(const char *path); /* is it one of these directories, or in one? */

/* ---- cache.c ---- */

/* cache_read(name) -> text | nil;  cache_write(name, text) -> was it kept?  name: hexadecimal
 * digits */
int host_cache_read(lua_State *L);
int host_cache_write(lua_State *L);
/* fingerprint() -> a hash of the generator in this program | nil when it comes from a source
 * tree */
int host_fingerprint(lua_State *L);

/* ---- output ---- */

/* out(text), err(text): write and return true, or nil, message.  A failure of standard output is
   remembered, reported once by the program's end, and turned into its exit status. */
int host_out(lua_State *L);
int host_err(lua_State *L);
/* isatty("out" | "err") -> boolean */
int host_isatty(lua_State *L);
/* coloured() -> may standard error have colours? */
int host_coloured(lua_State *L);
/* Flush; 0 or HOST_EXIT_OUTPUT after a message on standard error. */
int output_finish(void);

/* ---- process.c ---- */

/* execute({program, argument...}[, {dir=, seconds=}]) -> exit status, output | nil, message.
   No shell.  The output is standard output and error together, the first megabyte. */
int host_execute(lua_State *L);
/* compile(dir, {source, ...}, output[, {cc=, flags={...}, libs={...}}]) -> true, command | nil,
 * compiler's output */
int host_compile(lua_State *L);
/* compile_many({{dir, sources, output, options}, ...}[, at_once]) -> {{command =} or {message =},
   ...} Each as compile; as many at a time as there are processors, if it is not said. */
int host_compile_many(lua_State *L);
/* hand_over({program, argument...}) -> exit status, 128 + signal | nil, message.  The program has
   our standard output and error, and the signals that stop us. */
int host_hand_over(lua_State *L);
/* clock() -> seconds from a clock that only goes forward */
int host_clock(lua_State *L);

/* ---- sandbox/sandbox.c ---- */

/* sandbox(text, chunkname, env[, {bytes=, steps=, seconds=}])
     -> true, result... | false, {message=, line=, kind=, value=, source=, traceback=}
   Runs a text chunk with env as its globals.  kind: "syntax", "runtime", "memory", "steps", "time".
   line: the scene's innermost line, where there is one; message: without that place; value: the
   error as it was raised; source: the file that raised it.  Lua functions in env are replaced by
   visible(f). */
int host_sandbox(lua_State *L);
/* bounded(f, {bytes=, turnover=, seconds=, used=}, ...) -> true, f's results | false, message:
   which bound was passed.  turnover: bytes in all blocks there ever were, less `used`, which
   becomes that of this call and those before.  What f raises for another reason is raised again, a
   text with its traceback. */
int host_bounded(lua_State *L);
/* visible(f) -> a C function that calls f.  In `return f(x)` Lua drops the caller's frame before f
   runs, but keeps it for a C function, so that f can still find the line of the scene that called
   it. */
int sandbox_visible(lua_State *L);

/* ---- xml.c ---- */

/* xml(text) -> {name=, line=, at={[attribute]=value, [1..n]=names in order}, text=,
   [1..n]=elements} | nil, message, line.  No document types; bounded size, depth and number of
   elements. */
int host_xml(lua_State *L);

/* ---- engine ---- */

/* mass(scene) -> table | nil, message;  run(scene, options) -> {rows} | nil, message;
   rates(scene) -> object | nil, message;  plugin(path) -> object | nil, message;
   mesh(path, kind, options) -> table | nil, message, table: see engine/mesh.c
   processors(), baseline(), peers(): see bench/bench.h */
int host_mass(lua_State *L);
int host_run(lua_State *L);
int host_rates(lua_State *L);
int host_plugin(lua_State *L);
int host_mesh(lua_State *L);
int host_processors(lua_State *L);
int host_baseline(lua_State *L);
int host_peers(lua_State *L);

/* csv(path): see csv.h;  course(inputs): see course.h */
int host_csv(lua_State *L);
int host_course(lua_State *L);

/* fit(path, problem), design(path, problem), odd(csv), tail(chi2, dof): see fit/fit.h */
int host_fit(lua_State *L);
int host_design(lua_State *L);
int host_tail(lua_State *L);
int host_odd(lua_State *L);

#endif
