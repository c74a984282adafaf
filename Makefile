# texmap: perspective texture mapping in five stages. `make help` lists the targets.
# Needs gcc or clang, make and libc. V=1 shows the commands, BUILD=FOLDER builds elsewhere; CC and
# CFLAGS may be given too.

MAKEFLAGS += -r # no built-in rules: all that are used stand below
BUILD = build
CC = cc
AR = ar
CFLAGS = -O2
# Kept whatever CFLAGS say: without them another compiler or processor draws other bits.
KEPT = -std=c11 -ffp-contract=off -Wall -Wextra -Wpedantic -I.
LDLIBS = -lm

STAGES = $(filter-out stage5_asm,$(wildcard stage*_*))
# Stage 5 is for 64-bit x86 and ELF: elsewhere it is left out, and every command says so.
MACHINE := $(shell $(CC) $(CFLAGS) -E -dM -x c /dev/null 2>/dev/null)
ifeq ($(words $(filter __x86_64__ __ELF__ __LP64__,$(MACHINE))),3)
STAGES += stage5_asm
KEPT += -DTEXMAP_STAGE5
endif
SEGMENTS = 4 8 32 64 span
TRACED = $(foreach stage,$(STAGES),$(patsubst stage%,%,$(firstword $(subst _, ,$(stage)))))

# Two libraries: what the program is made of, and what only tests use. A program is its main file,
# tests/FOLDER/NAME_main.c for build/NAME, linked with them.
MAINS = $(wildcard tests/*/*_main.c)
OBJECTS_OF = $(patsubst %,$(BUILD)/%.o,$(filter-out $(MAINS:.c=),$(patsubst %.c,%,$(1))))
FOLDERS = common $(STAGES) \
	$(addprefix tests/,program exact judge files bench chart trace stability page)
LIBRARY = $(call OBJECTS_OF,$(wildcard $(FOLDERS:%=%/*.c) $(STAGES:%=%/*.S))) $(BUILD)/page.o \
	$(SEGMENTS:%=$(BUILD)/stage4_subdivide/segment_%.o) $(TRACED:%=$(BUILD)/trace/stage%.o) \
	$(if $(filter stage5_asm,$(STAGES)),$(BUILD)/trace/span.o)
TESTS = $(call OBJECTS_OF,$(wildcard tests/unit/*.c tests/asm/*.c \
	$(if $(filter stage5_asm,$(STAGES)),tests/asm/*.S)))
EXERCISES = $(call OBJECTS_OF,$(wildcard tests/lessons/exercises/*.c))
LIBRARIES = $(BUILD)/tests.a $(BUILD)/texmap.a
PROGRAMS = $(patsubst %_main.c,$(BUILD)/%,$(notdir $(MAINS)))

say = $(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),,@echo '$(1)  $(@:$(BUILD)/%=%)' &&)
# A stage's source compiled again, with other flags, is not announced.
compile = @mkdir -p $(@D)$(newline)$(if $(1),$(if $(V),,@),$(call say,CC)) $(CC) $(CFLAGS) $(KEPT) -MMD -MP $(1) -c -o $@ $<
define newline


endef

.PHONY: all test bench chart compare lesson exercise report page-wasm golden results \
	readme pictures stability steps debug clean help test-page test-exercises test-long test-matrix \
	test-contract test-aarch64 test-valgrind sanitize torture fuzz FORCE
.SECONDEXPANSION:

#: make               builds, draws the room through all stages, and prints their speed and accuracy
all: $(BUILD)/texmap
	@sh tests/lessons/room.sh $(BUILD)

#: make test          every test; ends with `N passed, N failed`
test: $(BUILD)/texmap $(BUILD)/test $(BUILD)/memory
	@$(BUILD)/test

#: make lesson N=2    what changed from stage 1 to stage 2: source, picture, accuracy and speed
lesson: $(BUILD)/texmap
	@sh tests/lessons/lesson.sh $(BUILD) '$(N)'

#: make compare N=3 [WITH=REV]   a changed stage against the last commit's: pixels, accuracy, speed
compare: $(BUILD)/texmap.a
	@sh tests/bench/compare.sh $(BUILD) '$(or $(WITH),HEAD)' . '$(N)'

#: make exercise N=3 E=1   an exercise of a lesson: your copy, built and judged
exercise: $(EXERCISES) $(LIBRARIES) $(BUILD)/texmap
	@sh tests/lessons/exercise.sh $(BUILD) '$(N)' '$(E)' $(EXERCISES) $(LIBRARIES)

#: make report        the page on which to step through what the stages do: build/report/index.html
report: $(BUILD)/texmap
	$(BUILD)/texmap report -o $(BUILD)/report

#: make page-wasm     the stages anew as the module that the page carries; needs clang and lld
page-wasm:
	sh tests/page/wasm/build.sh build $(MODULE)
	sh tests/page/wasm/build.sh sources > $(MODULE:base64=sources)

#: make bench         speed and accuracy of all stages on all scenes, to build/bench.csv
bench: $(BUILD)/texmap
	$(BUILD)/texmap bench --stage all --scene all --csv $(BUILD)/bench.csv

#: make chart         that, drawn: build/chart.svg
chart: bench
	$(BUILD)/texmap chart $(BUILD)/bench.csv -o $(BUILD)/chart.svg

#: make build/texmap  the program alone; build/texmap help says what it can do
$(foreach main,$(MAINS:.c=),$(eval \
	$(BUILD)/$(patsubst %_main,%,$(notdir $(main))): $(BUILD)/$(main).o))
$(BUILD)/texmap $(BUILD)/stability: $(BUILD)/texmap.a
$(filter-out %/texmap %/stability,$(PROGRAMS)): $(LIBRARIES)
$(PROGRAMS):
	$(call say,LD) $(CC) $(CFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(LDLIBS)
# texmap with allocations that fail, one after another, and a clock that runs fast.
$(BUILD)/memory: LDLIBS += $(foreach name,malloc calloc realloc open_memstream clock_gettime,-Wl,--wrap=$(name))

#: make debug         build/debug/texmap with -O0 -g, to step through a stage in gdb
debug:
	@$(MAKE) -s BUILD=$(BUILD)/debug CFLAGS='-O0 -g' $(BUILD)/debug/texmap

#: make clean         removes build/
clean:
	rm -rf $(BUILD)

help:
	@sed -n 's/^#: //p' Makefile

# q, not r: two folders may have a file of the same name.
$(BUILD)/texmap.a: $(LIBRARY)
$(BUILD)/tests.a: $(TESTS)
$(BUILD)/%.a:
	$(call say,AR) rm -f $@ && $(AR) qcs $@ $^

$(BUILD)/%.o: %.c $(BUILD)/flags
	$(compile)

$(BUILD)/%.S.o: %.S $(BUILD)/flags
	$(compile)

# Stage 4's own source with another distance between two divides.
$(BUILD)/stage4_subdivide/segment_%.o: stage4_subdivide/rasterize.c $(BUILD)/flags
	$(call compile,-DSEGMENT_LENGTH=$(subst span,4096,$*) \
		-Dstage4_draw_triangle=segment_$*_draw_triangle)

# The stages again, for `texmap trace`: there the macros of common/trace.h have a meaning.
$(BUILD)/trace/stage%.o: $$(wildcard stage$$*_*/rasterize.c) $(BUILD)/flags
	$(call compile,-DTEXMAP_TRACE='"tests/trace/hooks.h"' -DTRACE_STAGE=$* \
		-Dstage$*_draw_triangle=trace$*_draw_triangle \
		-Dstage5_draw_segments=stage5_draw_segments_in_steps)

# Which line of span.S each of its instructions comes from.
$(BUILD)/trace/span.S: tests/trace/lines.awk stage5_asm/span.S
	@mkdir -p $(@D)
	@awk -v routine=stage5_draw_segments -f $^ > $@

$(BUILD)/trace/span.o: $(BUILD)/trace/span.S $(BUILD)/flags
	$(compile)

# The page of `texmap report`: its files as one C file, and stages 1 to 4 as WebAssembly, made anew
# where clang and wasm-ld are.
MODULE = tests/page/stages.wasm.base64
$(BUILD)/page/stages.wasm.base64: $(MODULE) $(shell sh tests/page/wasm/build.sh list)
	@mkdir -p $(@D)
	$(call say,WASM) sh tests/page/wasm/build.sh choose $@

$(BUILD)/page.c: tests/page/embed.sh tests/page/page.html $(wildcard tests/page/*.css \
		tests/page/*.js stage[1-4]_*/rasterize.c stage5_asm/span.S) $(BUILD)/page/stages.wasm.base64
	$(call say,PAGE) sh $^ $(BUILD)/page/module-note.html > $@.new && mv $@.new $@

$(BUILD)/page.o: $(BUILD)/page.c $(BUILD)/flags
	$(compile)

# What `texmap bench` says it was built with.
$(BUILD)/tests/bench/machine.o: private override KEPT += '-DTEXMAP_FLAGS="$(CFLAGS) -std=c11 -ffp-contract=off"'

# What compiles a file here. It changes when the compiler or its flags do, so that nothing built with
# others is kept; and scripts that compile read it.
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(CFLAGS) $(KEPT)' | cmp -s - $@ || echo '$(CC) $(CFLAGS) $(KEPT)' > $@

#:
#: For those who change something; each says clearly what it misses:
#:
#: make golden        renews tests/golden/, after a change that means to move a frame
golden: $(BUILD)/test
	$(BUILD)/test --golden

#: make stability     the stability table and its curves, to tests/results/
stability: $(BUILD)/stability
	$(BUILD)/stability --csv tests/results/stability.csv --curves tests/results

#: make steps         stage 3 with one change undone at a time, to tests/results/: a quiet machine
steps: $(BUILD)/texmap
	@sh tests/lessons/steps.sh $(BUILD)

#: make results       tests/results/bench.csv and chart.svg, anew: two minutes of a quiet machine
results: $(BUILD)/texmap
	$(BUILD)/texmap bench --seconds 120 --csv tests/results/bench.csv
	$(BUILD)/texmap chart tests/results/bench.csv -o tests/results/chart.svg

#: make readme        the tables in the READMEs, anew from tests/results/ and what texmap prints
readme: $(BUILD)/texmap
	@TEXMAP_BUILD=$(BUILD) sh tests/lessons/readme.sh

#: make pictures      the pictures in the READMEs, anew
pictures: $(BUILD)/texmap
	@sh tests/lessons/pictures.sh $(BUILD)/texmap

#: make test-page     the page in headless Chromium, held against the program's own numbers
test-page: $(BUILD)/texmap
	@sh tests/page/test.sh $(BUILD)

#: make test-exercises  are the exercises' starting points failed, and their solutions passed?
test-exercises: $(EXERCISES) $(LIBRARIES)
	@sh tests/lessons/exercise.sh $(BUILD) prove $^

#: make test-long     stage 5's assembly against stage 4's C in 100 million spans, and the coda's error
#:                    in 100 million coordinates: a minute
test-long: $(BUILD)/test
	@TEXMAP_SEGMENTS=100000000 $(BUILD)/test asm
	@TEXMAP_COORDINATES=100000000 $(BUILD)/test coda

#: make test-matrix   the same frames from gcc and clang at -O0 to -O3 and -Os, and -march=native
#: make test-contract a build that may fuse a*b + c draws other frames, and the tests notice
#: make test-aarch64  stages 1 to 4 on another processor: the same frames, the same exact answer
test-matrix test-contract test-aarch64: test-%: $(BUILD)/texmap
	@CC='$(CC)' KEPT='$(KEPT)' sh tests/long/same_bits.sh $* $(BUILD)

#: make test-valgrind some of the tests under valgrind's memcheck: two minutes
test-valgrind: $(BUILD)/test
	@command -v valgrind > /dev/null || { echo 'valgrind is missing: Debian package valgrind'; exit 1; }
	@TEXMAP_SEGMENTS=10000 valgrind -q --error-exitcode=99 --leak-check=full \
		$(BUILD)/test raster asm files clip

#: make sanitize      every test, built with the address and undefined behaviour sanitizers
# A report ends the program with a status that no command has, so that a test that waits for an
# error does not take it for one.
SANITIZE = -O1 -g -fsanitize=address,undefined,float-cast-overflow,float-divide-by-zero \
	-fno-sanitize-recover=all
sanitize:
	@$(call has_clang,$(SANITIZE),int main(void) { return 0; })
	@ASAN_OPTIONS=detect_leaks=1:exitcode=99 UBSAN_OPTIONS=exitcode=99:print_stacktrace=1 \
		$(MAKE) -s BUILD=$(BUILD)/sanitize CC=clang CFLAGS='$(SANITIZE)' test

#: make torture       ten million random triangles through all stages, the promises as assertions
torture: $(BUILD)/test
	@TEXMAP_TRIANGLES=10000000 $(BUILD)/test gates

#: make fuzz          libFuzzer on the readers and on all stages, a minute each (FUZZ_SECONDS=60)
FUZZ_SECONDS = 60
FUZZERS = $(patsubst tests/long/fuzz_%.c,%,$(wildcard tests/long/fuzz_*.c))

$(FUZZERS:%=$(BUILD)/fuzz_%): $(BUILD)/%: $(BUILD)/tests/long/%.o $(LIBRARIES)
	$(call say,LD) $(CC) $(CFLAGS) -fsanitize=fuzzer -o $@ $^ $(LDLIBS)

fuzz:
	@$(call has_clang,-fsanitize=fuzzer, \
		int LLVMFuzzerTestOneInput(const char *b, unsigned long n) { return !b && n; })
	@$(MAKE) -s BUILD=$(BUILD)/fuzz CC=clang CFLAGS='$(SANITIZE) -fsanitize=fuzzer-no-link' \
		$(FUZZERS:%=$(BUILD)/fuzz/fuzz_%)
	@for target in $(FUZZERS); do \
		mkdir -p $(BUILD)/fuzz/corpus/$$target && \
		$(BUILD)/fuzz/fuzz_$$target -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 \
			-artifact_prefix=$(BUILD)/fuzz/ $(BUILD)/fuzz/corpus/$$target \
			tests/long/corpus/$$target $$([ $$target != files ] || echo tests/cases) || exit 1; \
	done

# Can clang build this program with these flags?
has_clang = mkdir -p $(BUILD) && echo '$(2)' | clang $(1) -x c -o $(BUILD)/tried - 2> $(BUILD)/tried.log || \
	{ echo "clang or its sanitizers are missing: Debian packages clang, libclang-rt-dev"; exit 1; }

-include $(patsubst %.o,%.d,$(LIBRARY) $(TESTS) $(EXERCISES) $(MAINS:%.c=$(BUILD)/%.o))
