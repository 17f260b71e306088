# fuzz.mk - the fuzz targets, built for libFuzzer or for replay.c, and run.  Called by the Makefile and by replay.t.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   OBJ      where the program's objects and libpolhode.a are (instrumented ones for libFuzzer)
#   OUT      where the targets go
#   ENGINE   fuzzer | replay
#   PROGRAM  a polhode that runs: it emits the scenes of the target `init`

OBJ     = build
OUT     = build/fuzz/replay
ENGINE  = replay
PROGRAM = build/polhode
CC      = cc
CFLAGS  = -O1 -g
SECONDS = 600
SEED    = 1758
RSS     = 2500
FUZZ    = tests/fuzz

ALL     = scene table command robot mesh_stl mesh_obj mesh_ply init

all: $(ALL:%=$(OUT)/%)

STD = -std=c11 -ffp-contract=off -D_XOPEN_SOURCE=700
ROOMS = -Isrc/cli -Isrc/runtime
LUA_CFLAGS := $(shell pkg-config --cflags lua5.4)
LUA_STATIC := $(wildcard $(shell pkg-config --variable=libdir lua5.4)/liblua5.4.a)
LIBS       := $(or $(LUA_STATIC),$(shell pkg-config --libs lua5.4)) $(shell pkg-config --libs expat gsl) -lmpfr -lgmp -ldl -lm

ifeq ($(ENGINE),fuzzer)
LINK  = -fsanitize=fuzzer
COVER = -DFUZZ_COVERAGE
else
DRIVER = $(OUT)/replay.o
endif

# ---- targets that go through Lua: the program without its main and with the harness' sandbox; nothing that times ----

ENGINES = scene table command robot
CLI := $(filter-out %/main.o %/bounds.o,$(patsubst src/cli/%.c,$(OBJ)/obj/cli/%.o,$(shell find src/cli -name '*.c'))) \
       $(OBJ)/obj/embedded.o

$(OUT)/replay.o: $(FUZZ)/replay.c $(FUZZ)/fuzz.h
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) -c -o $@ $<

$(OUT)/engine_sandbox.o: $(FUZZ)/engine_sandbox.c src/cli/sandbox/bounds.c
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(LUA_CFLAGS) $(ROOMS) -c -o $@ $<

$(ENGINES:%=$(OUT)/engine_%.o): $(OUT)/engine_%.o: $(FUZZ)/engine.c $(FUZZ)/fuzz.h
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(COVER) $(LUA_CFLAGS) $(ROOMS) -DFUZZ_MODE='"$*"' -c -o $@ $<

$(ENGINES:%=$(OUT)/%): $(OUT)/%: $(OUT)/engine_%.o $(OUT)/engine_sandbox.o $(DRIVER) $(CLI) $(OBJ)/libpolhode.a
	$(CC) $(CFLAGS) $(LINK) -o $@ $^ $(SUNDIALS_LIBS) $(LIBS)

# ---- mesh readers: their faces and their file pass through the harness ----

MESHES = mesh_stl mesh_obj mesh_ply
READER = $(patsubst src/runtime/mesh/%.c,$(OUT)/reader/%.o,$(wildcard src/runtime/mesh/*.c))

$(OUT)/reader/%.o: src/runtime/mesh/%.c src/runtime/mesh/mesh.h
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(ROOMS) -DMESH_BYTES=2048 $(if $(filter mesh_$*,$(MESHES)),-Dmesh_add_triangle=fuzz_add_triangle \
	  -Dmesh_add_polygon=fuzz_add_polygon) $(if $(filter $*,mesh),-Dfopen=fuzz_fopen) -c -o $@ $<

$(MESHES:%=$(OUT)/%.o): $(OUT)/%.o: $(FUZZ)/mesh.c $(FUZZ)/fuzz.h
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) $(ROOMS) -DFUZZ_SUFFIX='".$(*:mesh_%=%)"' -c -o $@ $<

$(MESHES:%=$(OUT)/%): $(OUT)/%: $(OUT)/%.o $(READER) $(DRIVER) $(OBJ)/libpolhode.a
	$(CC) $(CFLAGS) $(LINK) -o $@ $^ $(LIBS)

# ---- emitted code: each scene in double and, renamed, in float; what it has is read off its header ----

BODIES  = bracket heavy_top gyrostat wheels dropped_stone
OWN     = hollow tensor6 busy
EMITTED = $(sort $(BODIES) $(OWN))
CASES   = $(EMITTED) $(EMITTED:%=%_f)
XMACRO  = $(foreach s,$(CASES),X($(s)))

has = $$(grep -q '$(1)' $(OUT)/emit/$*.h && echo -DHAS_$(2))

$(OUT)/emit/%.lua: $(FUZZ)/scenes/%.lua
	@mkdir -p $(@D)
	@cp $< $@
$(OUT)/emit/%.lua: bodies/%.lua
	@mkdir -p $(@D)
	@cp $< $@
$(OUT)/emit/%_f.lua: $(OUT)/emit/%.lua
	@sed 's/"$*"/"$*_f"/' $< > $@
$(OUT)/emit/%_f.h $(OUT)/emit/%_f.c: $(OUT)/emit/%_f.lua $(PROGRAM)
	@$(PROGRAM) gen --layout single --with analysis,orbit $< --real float -o $(@D) && touch $(OUT)/emit/$*_f.[ch] # gen leaves what is the same
$(OUT)/emit/%.h $(OUT)/emit/%.c: $(OUT)/emit/%.lua $(PROGRAM)
	@$(PROGRAM) gen --layout single --with analysis,orbit $< -o $(@D) && touch $(OUT)/emit/$*.[ch]

# The scene's own step is in its self-test alone: `h = ` of the first step.
$(OUT)/init_%.o: $(OUT)/emit/%.h $(FUZZ)/init_scene.c $(FUZZ)/init.h $(FUZZ)/fuzz.h
	$(CC) $(STD) $(CFLAGS) -I$(OUT)/emit -I$(FUZZ) -DHEADER='"$*.h"' -DNAME=$* -DUPPER=$$(echo $* | tr a-z A-Z) \
	  -DSTATUSES=$$(sed -n 's/^ \*   \([0-9]*\)  .*/\1/p' $(OUT)/emit/$*.h | sort -n | tail -1) \
	  -DSTEP=$$(sed -n 's/.*time.*step = \([0-9.]*\).*/\1/p;$$a0.001' $(OUT)/emit/$*.lua | head -1) \
	  $(call has,int order,ORDER) $(call has,_solve.,SOLVE) $(call has,_set_tick.,TICK) $(call has,_nutation_range.,NUTATION) \
	  $(call has,_energy.,ENERGY) $(call has,_principal_of.,PRINCIPAL) $(call has,_spin_stable.,STABLE) \
	  -c -o $@ $(FUZZ)/init_scene.c
$(OUT)/emit_%.o: $(OUT)/emit/%.c
	$(CC) -std=c99 -ffp-contract=off $(CFLAGS) $(EMITTED_CFLAGS) -c -o $@ $(OUT)/emit/$*.c

$(OUT)/init.o: $(FUZZ)/init.c $(FUZZ)/init.h $(FUZZ)/fuzz.h $(FUZZ)/fuzz.mk
	@mkdir -p $(@D)
	$(CC) $(STD) $(CFLAGS) -DFUZZ_SCENES='$(XMACRO)' -c -o $@ $<

$(OUT)/init: $(OUT)/init.o $(DRIVER) $(CASES:%=$(OUT)/init_%.o) $(CASES:%=$(OUT)/emit_%.o)
	$(CC) $(CFLAGS) $(LINK) -o $@ $^ -lm

.PRECIOUS: $(OUT)/emit/%.lua $(OUT)/emit/%.h $(OUT)/emit/%.c $(OUT)/init_%.o $(OUT)/emit_%.o
.SECONDARY:

# ---- running, libFuzzer ----

WORK = $(OUT)/../work
LONG_scene = 12000
LONG_table = 2000
LONG_command = 400
LONG_robot = 12000
LONG_mesh_stl = 6000
LONG_mesh_obj = 4000
LONG_mesh_ply = 4000
LONG_init = 300

run: $(ALL:%=run-%)

# Leaks of Lua's blocks cannot be: its allocator counts them, and the state is closed.
$(ALL:%=run-%): run-%: $(OUT)/%
	@mkdir -p $(WORK)/$*
	@echo "fuzz: $* for $(SECONDS) s, seed $(SEED), at most $(RSS) MB"
	@cd $(FUZZ)/files && FUZZ_DIR=.. ASAN_OPTIONS=quarantine_size_mb=16:malloc_context_size=2 $(abspath $(OUT)/$*) -seed=$(SEED) -max_total_time=$(SECONDS) \
	  -rss_limit_mb=$(RSS) -max_len=$(LONG_$*) -timeout=300 -print_final_stats=1 -verbosity=1 \
	  $(if $(filter $(ENGINES),$*),-detect_leaks=0) -dict=../dict/$(firstword $(subst _, ,$*)).dict \
	  -artifact_prefix=$(abspath $(WORK))/$*- $(abspath $(WORK)/$*) ../corpus/$* ../regressions/$* \
	  > $(abspath $(WORK))/$*.log 2>&1; status=$$?; \
	  grep -E '^(Done|stat::number_of_executed)' $(abspath $(WORK))/$*.log; \
	  grep -E ' cov: ' $(abspath $(WORK))/$*.log | tail -1; \
	  [ $$status = 0 ] || { tail -40 $(abspath $(WORK))/$*.log; exit 1; }

merge: $(ALL:%=merge-%)

# The least of the corpus that covers as much.
$(ALL:%=merge-%): merge-%: $(OUT)/%
	@rm -rf $(WORK)/$*.least && mkdir -p $(WORK)/$*.least
	@cd $(FUZZ)/files && FUZZ_DIR=.. ASAN_OPTIONS=quarantine_size_mb=16:malloc_context_size=2 $(abspath $(OUT)/$*) -merge=1 -detect_leaks=0 -rss_limit_mb=$(RSS) \
	  -max_len=$(LONG_$*) $(abspath $(WORK)/$*.least) ../corpus/$* $(abspath $(WORK)/$*) \
	  > $(abspath $(WORK))/$*.merge.log 2>&1
	@ls $(WORK)/$*.least | wc -l

.PHONY: all run merge $(ALL:%=run-%) $(ALL:%=merge-%)
