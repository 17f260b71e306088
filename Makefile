# Makefile - build, test, install polhode.  Everything that is made goes to build/.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   make            the program build/polhode and the library build/libpolhode.a
#   make demo       set up what is missing, build, and walk one body through the whole chain
#   make check      set up what is missing, build, run the quick tests: five minutes on two cores
#   make check-all  the same with every test, half an hour; tests/tiers.txt says which test is in which
#   make check-target   the emitted code on small processors under emulators, and proofs; `.ci/setup target` installs them
#   make hard       every hard case, against its bound: docs/hard.md and its map (some minutes); make check-all has half of them
#   make check-latex  pdflatex sets the hand-out of every body without a warning; `.ci/setup latex` installs it
#   make check-typst  Typst's compiler takes each of them without a word; `.ci/setup typst` installs it in build/typst
#   make check-page   pages of `polhode view` in node and in Chromium; `.ci/setup page` installs them
#   make bits-all   the same bits on every machine, by both compilers, at every level (an hour); check-target has a part
#   make bench      build and run the measurements
#   make accuracy   docs/accuracy.md and its diagrams, measured anew (some minutes)
#   make dist       build/polhode-VERSION.tar.gz: the same commit, the same bytes
#   make deb        Debian packages, from that archive, in build/deb
#   make install    program, library, scenes, documents: PREFIX (default /usr/local), DESTDIR
#   make docs       docs/shapes.md and its pictures, docs/effects.md, docs/commands.md, docs/linearised.svg, docs/disc.svg,
#                   the tour in docs/design.md
#   make man | completions   man pages into build/man, completions for bash, zsh, fish into build/completions
#   make gallery    docs/gallery.md and a picture of each scene of bodies/
#   make drift      TURNS (default 100000): the table of drifts in docs/methods.md
#   make drift-laws   docs/drift.md: how errors grow with the number of steps, fitted (ten minutes)
#   make hunt       COUNT, SEED, HUNTED: a random search for the worst states, docs/hunt.md
#   make mutants COUNT=40 SEED=1   plants defects, looks which tests find them: docs/mutants.md (hours; SPEND=15: less)
#   make tiers      the seconds that the last make check or check-all took, into tests/tiers.txt
#   make coverage   which lines of generator and src a part of the tests runs: docs/coverage.md; fails below 95 %
#   make fuzz SECONDS=600 TARGETS='scene init'   libFuzzer (clang) on each target of tests/fuzz, see docs/fuzzing.md
#   make lint | format | sanitize | golden | clean

CC      = cc
CFLAGS  = -O2 -g
LDFLAGS =
PREFIX  = /usr/local
DESTDIR =
BUILD   = build
JOBS    = 2
PROVE   = prove -e '' -j$(JOBS)
LUA     = lua5.4

# ---- no need to change anything below ----

VERSION = 0.1.0
RELEASED = 2026-11-23# the day of the version, for its man pages and archives

WARN = -Wall -Wextra -pedantic -Wconversion -Wdouble-promotion -Wshadow \
       -Wstrict-prototypes -Wmissing-prototypes
# not -Wfloat-equal: exact comparisons with zero and with stored values are meant

# Two roads to every number are compared bit by bit: no contraction into fused operations.
STD = -std=c11 -ffp-contract=off
POSIX = -D_XOPEN_SOURCE=700

# A header of another folder is included by its path below one of these: "numbers/wide.h", "host/host.h".
ROOMS = -Isrc/cli -Isrc/runtime

MAKEFLAGS += --no-builtin-rules
.SUFFIXES:

# Asked for once and only when a recipe needs them: demo and check may have to install pkg-config first.
once       = $(eval $(1) := $(2))$($(1))
LUA_CFLAGS = $(call once,LUA_CFLAGS,$(shell pkg-config --cflags lua5.4))
LUA_STATIC = $(wildcard $(shell pkg-config --variable=libdir lua5.4)/liblua5.4.a)
LUA_LIBS   = $(call once,LUA_LIBS,$(or $(LUA_STATIC),$(shell pkg-config --libs lua5.4)) -ldl)
GSL_CFLAGS = $(call once,GSL_CFLAGS,$(shell pkg-config --cflags gsl))
GSL_LIBS   = $(call once,GSL_LIBS,$(shell pkg-config --libs gsl))
XML_CFLAGS = $(call once,XML_CFLAGS,$(shell pkg-config --cflags expat))
XML_LIBS   = $(call once,XML_LIBS,$(shell pkg-config --libs expat))

# Optional, for `polhode bench` alone: SUNDIALS 6 in double; linked statically where that is possible.
SUNDIALS_HEADERS = arkode/arkode_erkstep cvode/cvode nvector/nvector_serial sunlinsol/sunlinsol_dense \
                   sunnonlinsol/sunnonlinsol_fixedpoint
SUNDIALS_FLAGS = $(call once,SUNDIALS_FLAGS,$(shell { printf '\043include <%s.h>\n' $(SUNDIALS_HEADERS); \
  printf '\043if SUNDIALS_VERSION_MAJOR != 6 || !defined SUNDIALS_DOUBLE_PRECISION\n\043error no\n\043endif\n'; } | \
  $(CC) -E -x c - >/dev/null 2>&1 && echo -DPOLHODE_SUNDIALS))
SUNDIALS_STATIC = $(filter /%,$(shell for l in arkode cvode; do $(CC) -print-file-name=libsundials_$$l.a; done))
SUNDIALS_LIBS = $(if $(SUNDIALS_FLAGS),$(call once,SUNDIALS_FOUND,$(or $(SUNDIALS_STATIC),$(addprefix \
  -lsundials_,arkode cvode nvecserial sunlinsoldense sunmatrixdense sunnonlinsolfixedpoint generic))))

RUNTIME_SRC := $(sort $(shell find src/runtime -name '*.c'))
CLI_SRC     := $(sort $(shell find src/cli -name '*.c'))
RATIONAL_SRC := $(sort $(wildcard src/cli/rational/*.c))
TEST_SRC    := $(sort $(wildcard tests/runtime/*.c))
LUA_TESTS   := $(sort $(shell find tests -name '*.t'))

RUNTIME_OBJ := $(RUNTIME_SRC:src/%.c=$(BUILD)/obj/%.o)
CLI_OBJ     := $(CLI_SRC:src/%.c=$(BUILD)/obj/%.o) $(BUILD)/obj/embedded.o $(if $(COVERED),$(BUILD)/obj/hook.o)
C_TESTS     := $(TEST_SRC:tests/%.c=$(BUILD)/tests/%.t)

LIBRARY := $(BUILD)/libpolhode.a
PROGRAM := $(BUILD)/polhode
MODULE  := $(BUILD)/lua/polhode_rational.so
READY   := $(BUILD)/ready

all: $(PROGRAM) $(LIBRARY) $(MODULE)

# A missing header is named with its package before the compiler stumbles over it.
$(READY): .ci/setup
	@mkdir -p $(@D)
	@POLHODE_NO_INSTALL=1 CC="$(CC)" .ci/setup build
	@touch $@

$(BUILD)/obj/runtime/%.o: src/runtime/%.c | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(ROOMS) $(GSL_CFLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/obj/cli/%.o: src/cli/%.c | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(ROOMS) $(LUA_CFLAGS) $(XML_CFLAGS) $(GSL_CFLAGS) \
	  $(if $(filter main sandbox bounds interrupt,$(*F)),$(COVERED:%=-include %)) -MMD -MP -c -o $@ $<

# What the program says of itself: the version, and the commit where this folder is the top of a git tree.  Written
# only when it changed.
COMMIT = $(call once,COMMIT,$(shell git -c safe.directory='*' rev-parse --show-prefix 2>/dev/null | grep -qx '' && \
  git -c safe.directory='*' describe --always --dirty --abbrev=12 2>/dev/null))
$(BUILD)/version.h: FORCE
	@mkdir -p $(@D)
	@{ echo '#define POLHODE_VERSION "$(VERSION)"'; \
	  echo '#define POLHODE_BUILD "$(VERSION)$(if $(COMMIT),+$(COMMIT))"'; } > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# The effects of the library: each file of src/runtime/effects is one.
$(BUILD)/effects.h: FORCE
	@mkdir -p $(@D)
	@printf 'EFFECT(%s)\n' $(patsubst src/runtime/effects/%.c,%,$(filter src/runtime/effects/%,$(RUNTIME_SRC))) > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

$(BUILD)/obj/runtime/acts/named.o: $(BUILD)/effects.h
$(BUILD)/obj/runtime/acts/named.o: ROOMS += -I$(BUILD)
$(BUILD)/analyzed/runtime/acts/named: $(BUILD)/effects.h

$(BUILD)/obj/cli/host/host.o: $(BUILD)/version.h
$(BUILD)/obj/cli/host/host.o: POSIX += -I$(BUILD)
$(BUILD)/analyzed/cli/host/host: $(BUILD)/version.h

$(BUILD)/obj/cli/bench/sundials.o: POSIX += $(SUNDIALS_FLAGS)

$(LIBRARY): $(RUNTIME_OBJ)
	@rm -f $@
	$(AR) -qcs $@ $^

$(PROGRAM): $(CLI_OBJ) $(LIBRARY)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LUA_LIBS) $(XML_LIBS) $(SUNDIALS_LIBS) $(GSL_LIBS) -lmpfr -lgmp -lm

# The scripts as C arrays. embed.lua writes only what changed, so an unchanged tree compiles nothing.
$(BUILD)/embedded.c: FORCE | $(READY)
	@$(LUA) src/cli/embed.lua $@ generator templates src/cli/sandbox/safe.lua

$(BUILD)/obj/embedded.o: $(BUILD)/embedded.c
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(LUA_CFLAGS) -Isrc/cli -MMD -MP -c -o $@ $<

# The rational numbers alone, for tests that run under plain lua5.4.
$(MODULE): $(RATIONAL_SRC) src/cli/rational/rational.h | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(ROOMS) $(LUA_CFLAGS) -fPIC -shared $(LDFLAGS) -o $@ $(RATIONAL_SRC) -lmpfr -lgmp -lm

# ---- tests ----

# In the program that is covered, and a module for tests under plain lua5.4.
$(BUILD)/obj/hook.o $(BUILD)/lua/polhode_coverage.so: tests/coverage/hook.c tests/coverage/hook.h | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) -O2 $(WARN) $(POSIX) $(LUA_CFLAGS) -fPIC $(if $(filter %.so,$@),-shared,-c) -o $@ $<

$(BUILD)/tests/%.t: tests/%.c $(LIBRARY) | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(GSL_CFLAGS) -Isrc/runtime -Itests -MMD -MP -MF $@.d $(LDFLAGS) -o $@ $< \
	  $(LIBRARY) $(GSL_LIBS) -lmpfr -lgmp -lm

# The free top with MPFR's digits: the oracle of tests/oracle/free_top.t and of the error map; and the heavy top.
ORACLE := $(BUILD)/oracle/free_top
ORACLES := $(ORACLE) $(BUILD)/oracle/heavy_top
$(BUILD)/oracle/%: tests/oracle/%.c | $(READY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(LDFLAGS) -o $@ $< -lmpfr -lgmp -lm

tests: all $(C_TESTS) $(ORACLES)

# Tests together, by the list of tests/tiers.txt; one at a time by hand: `prove -e '' tests/cli/commands.t`.
tier = @files=$$($(LUA) tests/tiers.lua files $(1) $(BUILD) $(JOBS)) && \
  prove -Q -j$(JOBS) -e '$(LUA) tests/tiers.lua one $(BUILD)' $$files 3>&2

check: TIER = quick
check-all: TIER = all
check check-all:
	@CC="$(CC)" .ci/setup build check
	@$(MAKE) --no-print-directory test TIER=$(TIER)

TIER = quick
test: tests
	$(call tier,$(TIER))

# The seconds that the last run of a tier took, into the list.
tiers:
	@$(LUA) tests/tiers.lua take $(BUILD)

# The catalogue of hard cases, all of it; PATTERN picks by name (then the page is left as it is).
PATTERN =
hard: tests
	@mkdir -p $(BUILD)/hard
	@$(LUA) tests/hard/run.lua $(PROGRAM) $(BUILD)/hard "$(PATTERN)" $(if $(PATTERN),,docs/hard.md docs/hard.svg)

# What runs on other processors, under emulators, and what is proven by Frama-C; a test says which package it lacks.
check-target: all
	$(call tier,target)

check-latex: $(PROGRAM) $(MODULE)
	@LUA_CPATH='$(BUILD)/lua/?.so;;' $(LUA) tests/report/handout_latex.t

check-typst: $(PROGRAM)
	@$(LUA) tests/report/handout_typst.t

check-page: $(PROGRAM)
	@node tests/page/person.mjs
	@node tests/page/lecture.mjs
	@node tests/page/plane.mjs
	@node tests/page/bounce.mjs
	@node tests/page/selftests.mjs
	@node tests/page/bits.mjs

# Fuzzing with libFuzzer, docs/fuzzing.md; `fuzz-replay` builds the same targets for tests/fuzz/replay.t.
FUZZ_TARGETS = $(if $(TARGETS),$(TARGETS:%=run-%),run)
SECONDS = 600
SEED = 1758
FUZZ_FLAGS = -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all
fuzz: all
	@CC="$(CC)" .ci/setup build fuzz
	@$(MAKE) --no-print-directory -s BUILD=$(BUILD)/fuzz CC=clang \
	  CFLAGS="$(FUZZ_FLAGS) -fsanitize=fuzzer-no-link,address,undefined" $(BUILD)/fuzz/libpolhode.a $(BUILD)/fuzz/polhode
	@$(MAKE) --no-print-directory -s -k -f tests/fuzz/fuzz.mk ENGINE=fuzzer CC=clang OBJ=$(BUILD)/fuzz \
	  OUT=$(BUILD)/fuzz/bin PROGRAM=$(PROGRAM) SECONDS=$(SECONDS) SEED=$(SEED) SUNDIALS_LIBS="$(SUNDIALS_LIBS)" \
	  CFLAGS="$(FUZZ_FLAGS) -fsanitize=fuzzer-no-link,address,undefined" TARGETS="$(TARGETS)" $(FUZZ_TARGETS)

fuzz-replay:
	@$(MAKE) --no-print-directory -s -f tests/fuzz/fuzz.mk CC="$(CC)" OBJ=$(BUILD) OUT=$(BUILD)/fuzz/replay \
	  PROGRAM=$(PROGRAM) CFLAGS="$(CFLAGS)" SUNDIALS_LIBS="$(SUNDIALS_LIBS)" all

bits-all: all
	@POLHODE_BITS=all $(LUA) tests/target/bits.t

# Also what the C standard leaves to IEEE 754, which is a slip here more often than meant: x/0, and (int)1e99.
SANITIZERS = address,undefined,float-divide-by-zero,float-cast-overflow
sanitize: all # some tests load the module of rational numbers into a plain lua5.4
	@CC="$(CC)" .ci/setup build check
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/san \
	  CFLAGS="-O1 -g -fno-omit-frame-pointer -fsanitize=$(SANITIZERS) -fno-sanitize-recover=all" sanitized

# rational.t and faults.t load libraries into programs, hostile.t measures memory; the others mostly run what is not
# ours: compilers, integrators.  runtime/known.t runs long and reaches what the others reach.
UNSANITIZED = tests/cli/rational.t tests/cli/bench.t tests/cli/bench_peers.t tests/cli/bench_time.t tests/cli/sheet.t \
  tests/cli/hostile.t tests/cli/faults.t tests/cli/asking.t tests/cli/estimate.t
sanitized: $(PROGRAM) $(C_TESTS)
	@POLHODE=$(PROGRAM) POLHODE_SANITIZED=1 POLHODE_BODIES=$(CURDIR)/bodies $(PROVE) $(filter-out %/runtime/known.t,$(C_TESTS)) \
	  $(filter-out $(UNSANITIZED),$(filter tests/cli/%,$(LUA_TESTS)))

# The lines that ran: of C by gcov, of the generator by a hook (tests/coverage/hook.c), in a build of their own.
# What a process saw survives its end by a signal; processes at the same time do not disturb each other.  known.t is
# a sweep of many seconds that runs one line of its own.
FLOOR = 95
coverage: tests
	@CC="$(CC)" .ci/setup build check
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/cov COVERED=tests/coverage/hook.h CFLAGS="-O0 -g --coverage" covered

COVERING = package.loadlib("$(abspath $(BUILD))/lua/polhode_coverage.so", "luaopen_polhode_coverage")() \
  package.preload.polhode_rational = \
  package.loadlib("$(abspath $(MODULE))", "luaopen_polhode_rational")
covered: all $(C_TESTS) $(BUILD)/lua/polhode_coverage.so
	@rm -rf $(BUILD)/lines && mkdir $(BUILD)/lines && find $(BUILD) -name '*.gcda' -delete
	@POLHODE=$(PROGRAM) POLHODE_BODIES=$(CURDIR)/bodies POLHODE_COVERAGE=$(abspath $(BUILD))/lines POLHODE_COVERED=$(CURDIR) LUA_INIT='$(COVERING)' \
	  $(PROVE) $(filter-out %/known.t,$(C_TESTS)) $$(sed 's/ *#.*//' tests/coverage/tests.txt) || \
	  echo "coverage: a test failed in this slow build; make check-all is its judge, here lines count"
	@$(LUA) tests/coverage/report.lua $(BUILD) docs/coverage.md $(FLOOR)

# The pages of all shapes with their pictures, of all effects, of all commands: docs/tools.
docs: $(PROGRAM) $(MODULE)
	@$(LUA) docs/tools/pages.lua docs
	@$(LUA) docs/tools/tour.lua $(PROGRAM) docs/design.md
	@$(PROGRAM) chart bodies/book.lua --linearised -o docs/linearised.svg
	@$(LUA) docs/tools/disc.lua docs/disc.svg

# Man pages and completions for bash, zsh and fish, from the tables that the command line is read with.
man: $(MODULE)
	@mkdir -p $(BUILD)/man
	@$(LUA) docs/tools/manual.lua $(BUILD)/man $(VERSION) $(RELEASED)

completions: $(MODULE)
	@mkdir -p $(BUILD)/completions
	@$(LUA) docs/tools/completions.lua $(BUILD)/completions

# A picture of each scene of bodies/, and the page that shows them.
gallery: $(PROGRAM)
	@$(LUA) docs/tools/gallery.lua $(PROGRAM) docs

golden: all
	@POLHODE_GOLDEN=refresh $(LUA) tests/emit/golden.t

# The emitted code that is measured, with the flags that its own Makefile uses.
$(BUILD)/bench/%.c: bodies/%.lua $(PROGRAM)
	@$(PROGRAM) gen --layout single --with analysis,orbit $< -o $(@D)

$(BUILD)/bench/%.o: $(BUILD)/bench/%.c
	$(CC) -std=c99 -O2 -ffp-contract=off -c -o $@ $<

$(BUILD)/bench/hand.o: tests/bench/hand.c tests/bench/hand.h
	@mkdir -p $(@D)
	$(CC) -std=c99 -O2 -c -o $@ $<

BENCH_OBJ = $(BUILD)/bench/hand.o $(BUILD)/bench/brick_centroid.o $(BUILD)/bench/symmetric_top.o

$(BUILD)/bench/step: tests/bench/step.c $(BENCH_OBJ)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(GSL_CFLAGS) -Itests/bench -I$(BUILD)/bench -o $@ $^ $(GSL_LIBS) -lm

# the same scene once more, for this machine
HOST = -O3 -march=native -fno-math-errno -ffp-contract=fast \
       $(if $(filter x86_64,$(shell uname -m)),-mprefer-vector-width=512)
$(BUILD)/bench/tumbling_host.c: bodies/tumbling_box.lua $(PROGRAM)
	@mkdir -p $(@D)
	@sed 's/"tumbling_box"/"tumbling_host"/' $< > $(@:.c=.lua)
	@$(PROGRAM) gen --layout single --with analysis,orbit $(@:.c=.lua) -o $(@D)

$(BUILD)/bench/tumbling_host.o: $(BUILD)/bench/tumbling_host.c
	$(CC) -std=c99 $(HOST) -c -o $@ $<

TOP_OBJ = $(BUILD)/bench/hand.o $(BUILD)/bench/tumbling_box.o $(BUILD)/bench/tumbling_host.o

$(BUILD)/bench/top: tests/bench/top.c $(TOP_OBJ) $(LIBRARY)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(GSL_CFLAGS) -Isrc/runtime -Itests/bench -I$(BUILD)/bench -o $@ $^ $(GSL_LIBS) -lm

# many bodies at once: the same scene, in lanes of three widths
$(BUILD)/bench/many_%/tumbling_box.c: bodies/tumbling_box.lua $(PROGRAM)
	@mkdir -p $(@D)
	@$(PROGRAM) gen --layout single --method rk4,taylor --with batch --real $* $< -o $(@D) > $(@D).log

LANES_512 = -march=native -mprefer-vector-width=512
LANES_256 = -march=native -mprefer-vector-width=256
LANES_128 =
bench-many: $(BUILD)/bench/hand.o $(BUILD)/bench/many_double/tumbling_box.c $(BUILD)/bench/many_float/tumbling_box.c
	@for real in double:1e-9 float:1e-4f; do \
	  for lanes in "512 $(LANES_512)" "256 $(LANES_256)" "128 $(LANES_128)"; do \
	    set -- $$lanes; dir=$(BUILD)/bench/many_$${real%:*}; width=$$1; shift; \
	    $(CC) -std=c99 -O2 -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize "$$@" -c -o $$dir/box.o \
	      $$dir/tumbling_box.c || exit; \
	    $(CC) $(STD) $(CFLAGS) $(POSIX) -DTOLERANCE=$${real#*:} -Itests/bench -I$$dir -o $$dir/many \
	      tests/bench/many.c $$dir/box.o $(BUILD)/bench/hand.o -lm || exit; \
	    $$dir/many "$${real%:*}, vectors of $$width bits" || exit; \
	  done; \
	done

# and of each scene of bodies/ the step of one body beside that of many, 512 bits
bench-many-bodies: $(PROGRAM)
	@printf '%-20s %8s %8s %8s\n' 'ns a step' one many ratio
	@for scene in bodies/*.lua; do \
	  name=$$(basename $$scene .lua); dir=$(BUILD)/bench/many_bodies/$$name; mkdir -p $$dir; \
	  $(PROGRAM) gen --layout single --method rk4 --with batch $$scene -o $$dir > $$dir/log || exit; \
	  $(CC) -std=gnu99 -O2 -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize $(LANES_512) -DNAME=$$name \
	    -DNX=$$(echo $$name | tr a-z A-Z)_NX -include $$dir/$$name.h -o $$dir/many tests/bench/many_any.c \
	    $$dir/$$name.c -lm || exit; \
	  $$dir/many || exit; \
	done

# the same members by `polhode sweep` and by GSL in a loop, on one thread
SWEPT = --sample 16384 --vary 'wx=normal(1,0.1)' --until 100 --method taylor --step 0.0714
bench-sweep: $(PROGRAM)
	@mkdir -p $(BUILD)/bench/sweep
	@$(PROGRAM) sweep tumbling_box $(SWEPT) --emit $(BUILD)/bench/sweep > $(BUILD)/bench/sweep.log
	@$(MAKE) -s -C $(BUILD)/bench/sweep HDF5=0
	@$(CC) $(STD) $(CFLAGS) $(POSIX) $(GSL_CFLAGS) -o $(BUILD)/bench/sweep_gsl tests/bench/sweep_gsl.c $(GSL_LIBS) -lm
	@$(BUILD)/bench/sweep_gsl $(BUILD)/bench/swept.csv \
	  "$(BUILD)/bench/sweep/tumbling_box_sweep --threads 1 -o $(BUILD)/bench/swept.csv" 100 1e-9

# `polhode fit` and scipy's least_squares on the same log
bench-fit: $(PROGRAM)
	@mkdir -p $(BUILD)/bench/fit
	@$(LUA) tests/bench/fit.lua $(PROGRAM) $(BUILD)/bench/fit

# a rolling ball by the emitted code, and by Simbody and scipy where they are (.ci/setup peers python)
ROLLED = $(BUILD)/bench/plane
bench-plane: $(PROGRAM)
	@mkdir -p $(ROLLED)
	@$(PROGRAM) gen chaplygin_ball --method adaptive,taylor --layout single -o $(ROLLED) > $(ROLLED)/log
	@$(CC) $(STD) $(CFLAGS) $(POSIX) -I$(ROLLED) -o $(ROLLED)/emitted tests/bench/plane.c $(ROLLED)/chaplygin_ball.c -lm
	@printf '%-40s %12s %12s %12s\n' 'a ball that rolls for 5 s' 'ns the rates' 'ms a run' 'error rad/s'
	@$(ROLLED)/emitted $(ROLLED)/truth 5
	@if $(CXX) -O2 -w -isystem /usr/include/simbody -o $(ROLLED)/simbody tests/bench/plane_simbody.cpp \
	  -lSimTKsimbody -lSimTKmath -lSimTKcommon 2> $(ROLLED)/simbody.log; then $(ROLLED)/simbody $(ROLLED)/truth 5; \
	  else echo 'Simbody is missing (Debian package libsimbody-dev)'; fi
	@/usr/bin/python3 tests/bench/plane_scipy.py $(ROLLED)/truth 5 2> $(ROLLED)/scipy.log || \
	  echo 'scipy is missing (Debian package python3-scipy)'

$(BUILD)/bench/rhs: tests/bench/rhs.c $(BUILD)/bench/heavy_top.o $(LIBRARY)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) $(GSL_CFLAGS) -Isrc/runtime -I$(BUILD)/bench -o $@ $^ $(GSL_LIBS) -lm

$(BUILD)/bench/mesh: tests/bench/mesh.c tests/mesh_files.h $(LIBRARY)
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) -Isrc/runtime -Itests -o $@ $< $(LIBRARY) $(GSL_LIBS) -lmpfr -lgmp -lm

$(BUILD)/bench/gen: tests/bench/gen.c
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) -o $@ $<

BODIES = $(sort $(wildcard bodies/*.lua))

.PRECIOUS: $(BUILD)/bench/%.c
bench: all $(BUILD)/bench/step $(BUILD)/bench/rhs $(BUILD)/bench/top $(BUILD)/bench/gen $(BUILD)/bench/mesh
	@$(BUILD)/bench/step
	@$(BUILD)/bench/rhs
	@$(BUILD)/bench/top
	@$(BUILD)/bench/gen $(PROGRAM) $(BUILD)/bench/out $(BODIES)
	@$(BUILD)/bench/mesh $(BUILD)/bench/mesh.stl
	@$(MAKE) --no-print-directory accuracy
	@echo "emitted code against the general library, all bodies, 1000 random states each"
	@$(PROGRAM) check --real double $(BODIES) > $(BUILD)/bench/check.tap; status=$$?; \
	  grep -e 'to 8 ulp' -e 'closed form is' -e '^not ok' $(BUILD)/bench/check.tap | sed 's/^\(.*ok\) [0-9]* - /  \1 /'; \
	  exit $$status

# The emitted free top against 50 digits: a sweep of bodies, motions and times, in double and float.
MAP := $(BUILD)/errormap
$(MAP)/%/errormap.c: tests/bench/errormap.lua $(PROGRAM)
	@mkdir -p $(@D)
	@$(PROGRAM) gen --layout single --with analysis,orbit $< --real $* -o $(@D) > $(@D).log

$(MAP)/%/sweep: tests/bench/errormap.c $(MAP)/%/errormap.c
	$(CC) $(STD) $(CFLAGS) $(WARN) -I$(@D) -o $@ $^ -lm

$(MAP)/%/errors: $(MAP)/%/sweep $(ORACLE)
	@$< $(@D)/places > $(@D)/lines
	@$(ORACLE) -b 512 -e < $(@D)/lines > $@

.SECONDARY:
errormap: $(MAP)/double/errors $(MAP)/float/errors
	@$(LUA) tests/bench/errormap_report.lua $(MAP) docs/errormap.md docs/errormap.svg

# Other people's integrators on the hard cases: the tables of docs/hard_peers.md.
HARD_SRC = $(addprefix tests/bench/hard_,peers.c cases.c gsl.c sundials.c numbers.c)
HARD_MADE = $(BUILD)/hard/hardtop.c $(BUILD)/hard/harddamped.c
$(BUILD)/hard/%.c: tests/bench/%.lua $(PROGRAM)
	@mkdir -p $(@D)
	@$(PROGRAM) gen --layout single --with analysis,orbit $< -o $(@D)

$(BUILD)/hard/peers: $(HARD_SRC) tests/bench/hard_peers.h $(HARD_MADE) $(MAP)/double/errormap.c $(LIBRARY)
	$(CC) $(STD) $(CFLAGS) $(WARN) $(POSIX) -D_DEFAULT_SOURCE $(SUNDIALS_FLAGS) $(GSL_CFLAGS) -Isrc/runtime -I$(BUILD)/hard \
	  -I$(MAP)/double -o $@ $(filter %.c,$^) $(LIBRARY) $(SUNDIALS_LIBS) $(GSL_LIBS) -lmpfr -lgmp -lm

hard-peers: $(BUILD)/hard/peers $(ORACLES)
	@$< $(BUILD)/oracle $(BUILD)/hard/lines > $(BUILD)/hard/tables
	@sed -i '/^<!-- tables -->$$/q' docs/hard_peers.md && cat $(BUILD)/hard/tables >> docs/hard_peers.md

# Energy and momentum of every stepper in a long run: the table in docs/methods.md.
TURNS = 100000
drift: $(PROGRAM)
	@$(LUA) tests/bench/drift.lua $(PROGRAM) $(BUILD)/drift $(TURNS) docs/methods.md

# Planted defects, and which tests find them: tests/mutants/mutants.lua and docs/mutants.md.
mutants: COUNT = 40
mutants: SEED = 1
mutants: TIER = all
mutants: SPEND = 9999
mutants: tests
	@$(LUA) tests/mutants/mutants.lua $(BUILD) $(COUNT) $(SEED) docs/mutants.md $(SPEND) $(filter quick,$(TIER))

# How errors grow with the number of steps: exponents, fitted over ensembles of states; docs/drift.md and its diagram.
drift-laws: $(PROGRAM) $(LIBRARY)
	@rm -rf $(BUILD)/laws
	@$(LUA) tests/bench/laws.lua $(PROGRAM) $(LIBRARY) $(BUILD)/laws docs/drift.md docs/drift.svg

# A random search for the states that are computed worst: tests/hunt/worst.lua and docs/hunt.md.
COUNT  = 1e6
HUNTED =
hunt: SEED = 1
hunt: $(PROGRAM) $(LIBRARY) $(MODULE)
	@$(LUA) tests/hunt/hunt.lua $(PROGRAM) $(BUILD)/hunt $(COUNT) $(SEED) "$(HUNTED)"

# Work and precision of every method on six scenes: tables and diagrams of docs/accuracy.md.  One at a time, please.
accuracy: $(PROGRAM)
	@$(LUA) tests/bench/accuracy.lua $(PROGRAM) $(BUILD)/accuracy docs/accuracy.md

# What the emitted free top costs on a Cortex-M4F: bytes, and instructions counted under QEMU.
target-cost: $(PROGRAM)
	@$(LUA) tests/target/cost.lua $(PROGRAM) $(BUILD)/target

# What operations take on small processors: generator/cost/measured.lua and the tables of docs/targets.md.
target-costs: $(PROGRAM) $(BUILD)/lua/polhode_rational.so
	@$(LUA) tests/target/costs.lua $(PROGRAM) $(BUILD)/target generator/cost/measured.lua docs/targets.md

# One body through the whole chain; each step shows the command that makes it.
DEMO = bodies/brick.lua
say  = @printf '\n\033[1m%s\033[0m\n' "$(1)"

demo:
	@CC="$(CC)" .ci/setup build
	@$(MAKE) --no-print-directory -s all
	$(call say,1. A scene: $(DEMO))
	@cat $(DEMO)
	$(call say,2. polhode explain $(DEMO)   (the first lines))
	@$(PROGRAM) explain $(DEMO) | sed -n "1,31p"
	$(call say,3. polhode gen $(DEMO) -o $(BUILD)/demo)
	@$(PROGRAM) gen $(DEMO) -o $(BUILD)/demo && wc -l $(BUILD)/demo/*
	$(call say,4. make -C $(BUILD)/demo check   (compile the emitted C and run its own self-test))
	@$(MAKE) --no-print-directory -s -C $(BUILD)/demo check
	$(call say,5. The motion by the emitted code and by the general library: t qw qx qy qz wx wy wz)
	@for e in generated general; do echo "polhode run $(DEMO) --engine $$e --at 0.5,1"; \
	  $(PROGRAM) run $(DEMO) --engine $$e --at 0.5,1 | tail -n 2 | cut -d, -f1-8; done
	$(call say,6. polhode check $(DEMO)   (1000 random states and parameters against the general library))
	@$(PROGRAM) check $(DEMO)

# ---- lint ----

C_FILES   := $(sort $(shell find src tests -name '*.[ch]')) $(filter-out templates/target/calls.c,$(wildcard templates/host/plugin.h templates/target/*.[ch]))
LUA_FILES := $(sort $(shell find generator tests bodies docs src/cli -name '*.lua' 2>/dev/null)) $(LUA_TESTS)

lint: lint-house lint-lua lint-c lint-format lint-analyzer

# Which part may know which, rooms, names, sizes: the house's own rules.
lint-house:
	@mkdir -p $(BUILD); $(LUA) tests/layers.t >$(BUILD)/house && $(LUA) tests/sizes.t >>$(BUILD)/house || { grep -v '^ok' $(BUILD)/house; exit 1; }

lint-setup:
	@CC="$(CC)" .ci/setup build lint

lint-lua: lint-setup
	@luacheck --quiet $(LUA_FILES)

lint-c: lint-setup
	@cppcheck --quiet --error-exitcode=1 --inline-suppr --std=c11 \
	  --enable=warning,performance,portability --suppress=missingIncludeSystem $(ROOMS) src

# gcc's analyzer on our C and on emitted steppers; the emitted closed forms take it minutes each and are left out.
lint-analyzer: lint-setup $(patsubst src/%.c,$(BUILD)/analyzed/%,$(RUNTIME_SRC) $(CLI_SRC)) \
               $(addprefix $(BUILD)/analyzed/emitted/,heavy_top wheels foucault gyrostat)

ANALYZE = gcc -O0 -fanalyzer -Werror -S -o /dev/null
$(BUILD)/analyzed/%: src/%.c | $(READY)
	@mkdir -p $(@D)
	$(ANALYZE) $(STD) $(POSIX) $(ROOMS) $(LUA_CFLAGS) $(XML_CFLAGS) $(GSL_CFLAGS) -I$(BUILD) -MMD -MP -MT $@ -MF $@.d $<
	@touch $@

# Arrays that a loop or a function called fills are unset to gcc 12; memcheck knows better (tests/analysis/valgrind.t).
$(addprefix $(BUILD)/analyzed/,cli/engine/program \
  $(addprefix runtime/,geometry/geometry geometry/arcs motion/linearised mesh/topology)): \
  ANALYZE += -Wno-analyzer-use-of-uninitialized-value
# `output` is NULL before it is set: struct child comes zeroed, which gcc 12 does not follow through the array of them.
$(BUILD)/analyzed/cli/host/process: ANALYZE += -Wno-analyzer-malloc-leak

$(BUILD)/analyzed/emitted/heavy_top: EMITTED_METHODS = rk4,semi,midpoint,adaptive
$(BUILD)/analyzed/emitted/gyrostat:  EMITTED_METHODS = split4,semi
EMITTED_METHODS = rk4
$(BUILD)/analyzed/emitted/%: bodies/%.lua $(PROGRAM)
	@mkdir -p $(@D)
	@$(PROGRAM) gen --layout single --with analysis $< --method $(EMITTED_METHODS) -o $@.c > $@.log
	$(ANALYZE) -std=c99 $@.c/$(*F).c
	@touch $@

lint-format: lint-setup
	@clang-format --dry-run -Werror $(C_FILES)

format: lint-setup
	@clang-format -i $(C_FILES)

# ---- installation ----

define PC_FILE
prefix=$(PREFIX)
includedir=$${prefix}/include
libdir=$(patsubst $(PREFIX)/%,$${prefix}/%,$(LIBDIR))

Name: polhode
Description: Mass properties and motion of rigid bodies
Version: $(VERSION)
Requires: gsl
Cflags: -I$${includedir}
Libs: -L$${libdir} -lpolhode -lm
endef
export PC_FILE

# The program finds its scenes by its own place (src/cli/host/file_read.c), so the whole may be moved.
SHARE = $(DESTDIR)$(PREFIX)/share
LIBDIR = $(PREFIX)/lib
ZSHDIR = $(PREFIX)/share/zsh/site-functions
install: all man completions
	install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(PREFIX)/include \
	  $(SHARE)/polhode/bodies $(SHARE)/doc/polhode $(SHARE)/man/man1 $(SHARE)/man/man3 $(SHARE)/man/man5 \
	  $(SHARE)/bash-completion/completions $(DESTDIR)$(ZSHDIR) $(SHARE)/fish/vendor_completions.d
	install -m 755 $(PROGRAM) $(DESTDIR)$(PREFIX)/bin/polhode
	install -m 644 $(LIBRARY) $(DESTDIR)$(LIBDIR)/libpolhode.a
	install -m 644 src/runtime/polhode.h src/runtime/polhode_exact.h src/runtime/polhode_move.h \
	  src/runtime/polhode_acts.h src/runtime/polhode_attitude.h src/runtime/polhode_mesh.h \
	  src/runtime/polhode_plane.h $(DESTDIR)$(PREFIX)/include/
	printf '%s\n' "$$PC_FILE" > $(DESTDIR)$(LIBDIR)/pkgconfig/polhode.pc
	for n in 1 3 5; do install -m 644 $(BUILD)/man/*.$$n $(SHARE)/man/man$$n/ || exit 1; done
	install -m 644 $(BUILD)/completions/polhode.bash $(SHARE)/bash-completion/completions/polhode
	install -m 644 $(BUILD)/completions/_polhode $(DESTDIR)$(ZSHDIR)/_polhode
	install -m 644 $(BUILD)/completions/polhode.fish $(SHARE)/fish/vendor_completions.d/polhode.fish
	install -m 644 bodies/* $(SHARE)/polhode/bodies/
	@echo 'README.md and docs into $(SHARE)/doc/polhode'
	@for f in README.md $$(find docs -path docs/tools -prune -o -type f -print); do install -D -m 644 $$f $(SHARE)/doc/polhode/$$f || exit 1; done
	install -m 644 LICENSE $(SHARE)/doc/polhode/LICENSE
	install -m 644 templates/LICENSE $(SHARE)/doc/polhode/LICENSE.templates

# ---- packages ----

# What is committed on HEAD, with the commit's time: the same commit gives the same bytes.
DIST = polhode-$(VERSION)
dist:
	@mkdir -p $(BUILD)
	@git -c safe.directory='*' archive --format=tar --prefix=$(DIST)/ HEAD | gzip -9n > $(BUILD)/$(DIST).tar.gz
	@echo $(BUILD)/$(DIST).tar.gz

# Debian packages polhode and libpolhode-dev from that archive; its Debian files are .ci/debian.
deb: dist
	@CC="$(CC)" .ci/setup build package
	@rm -rf $(BUILD)/deb && mkdir -p $(BUILD)/deb && tar -xzf $(BUILD)/$(DIST).tar.gz -C $(BUILD)/deb
	@cp -r $(BUILD)/deb/$(DIST)/.ci/debian $(BUILD)/deb/$(DIST)/debian
	@cd $(BUILD)/deb/$(DIST) && env -u MAKEFLAGS -u MAKELEVEL dpkg-buildpackage -b -us -uc > ../log 2>&1 || { tail -n 30 ../log; exit 1; }
	@ls $(BUILD)/deb/*.deb

clean:
	rm -rf $(BUILD)

FORCE:

.PHONY: all tests check check-all tiers mutants fuzz fuzz-replay check-target check-latex check-typst check-page bits-all test sanitize sanitized coverage covered golden docs gallery bench bench-many bench-many-bodies bench-sweep bench-fit bench-plane accuracy drift drift-laws hunt hard hard-peers errormap target-cost target-costs demo install man completions dist deb clean FORCE \
        lint format lint-setup lint-house lint-lua lint-c lint-format lint-analyzer
.DELETE_ON_ERROR:

-include $(RUNTIME_OBJ:.o=.d) $(CLI_OBJ:.o=.d) $(C_TESTS:=.d) $(wildcard $(BUILD)/analyzed/*/*.d $(BUILD)/analyzed/*/*/*.d)
