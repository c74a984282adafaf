# texmap: perspective texture mapping in five stages. `make help` lists the targets.
# Needs a C11 compiler, make and libc. CC and CFLAGS may be given on the command line.

MAKEFLAGS += -r # no built-in rules: all that are used stand below
BUILD = build
CC = cc
CFLAGS = -O2
# Kept whatever CFLAGS say: without them another compiler or processor draws other bits.
KEPT = -std=c11 -ffp-contract=off -Wall -Wextra -Wpedantic -I. -MMD -MP
LDLIBS = -lm

STAGES = stage1_float stage2_dda stage3_fixed28_4 stage4_subdivide
# Stage 5 is for 64-bit x86 and ELF: elsewhere it is left out, and every command says so.
MACHINE := $(shell $(CC) $(CFLAGS) -E -dM -x c /dev/null 2>/dev/null)
ifeq ($(words $(filter __x86_64__ __ELF__ __LP64__,$(MACHINE))),3)
STAGES += stage5_asm
KEPT += -DTEXMAP_STAGE5
ASM = $(patsubst stage5_asm/%.S,%,$(wildcard stage5_asm/*.S))
endif
SEGMENTS = 4 8 32 64 span
TRACED = 1 2 3 4

# Programs of their own, by their main file; the folders that texmap is made of; what only the tests use.
MAINS = $(wildcard tests/*/*_main.c)
PROGRAM_OF = $(BUILD)/$(patsubst %_main.c,%,$(notdir $(1)))
SHARED_SOURCES = $(filter-out $(MAINS) tests/program/texmap.c, \
	$(foreach f,program exact files bench chart trace page stability lessons,$(wildcard tests/$(f)/*.c)))
TEST_SOURCES = $(filter-out $(MAINS),$(wildcard tests/unit/*.c tests/asm/*.c tests/judge/*.c))

PROMISES = $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/judge/*.c) tests/unit/check.c)

STAGE_OBJECTS = $(STAGES:%=$(BUILD)/%/rasterize.o) $(ASM:%=$(BUILD)/stage5_asm/%.o) \
	$(if $(filter span_exact_avx2,$(ASM)),$(BUILD)/stage5_asm/coda.o) \
	$(SEGMENTS:%=$(BUILD)/stage4_subdivide/segment_%.o) $(TRACED:%=$(BUILD)/trace/stage%.o)
# The page of `texmap report`: its files, as one C file.
PAGE_FILES = $(sort $(wildcard tests/page/*.html tests/page/*.css tests/page/*.js))
SHARED = $(BUILD)/page.o $(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c) $(SHARED_SOURCES)) $(STAGE_OBJECTS)
TEST_OBJECTS = $(TEST_SOURCES:%.c=$(BUILD)/%.o) \
	$(if $(ASM),$(patsubst %.S,$(BUILD)/%.o,$(wildcard tests/asm/*.S)))

.PHONY: all test test-mistakes test-trace golden bench chart lesson clean help FORCE

# The main job: the room through all five stages.
all: $(BUILD)/texmap $(BUILD)/room
	@$(BUILD)/room $(BUILD)/out

test: $(BUILD)/texmap $(BUILD)/test test-mistakes test-trace
	@$(BUILD)/test

test-mistakes: $(SHARED) $(TEST_OBJECTS) $(BUILD)/tests/mistakes/main.o
	@CC='$(CC)' CFLAGS='$(CFLAGS) $(KEPT)' sh tests/mistakes/mistakes.sh $(BUILD) \
		$(BUILD)/tests/mistakes/main.o $(SHARED) $(TEST_OBJECTS)

test-trace:
	@CC='$(CC)' CFLAGS='$(CFLAGS) -std=c11 -ffp-contract=off -I.' sh tests/trace/vanishes.sh

golden: $(BUILD)/test
	$(BUILD)/test --golden

bench: $(BUILD)/texmap
	$(BUILD)/texmap bench --stage all --scene all --csv $(BUILD)/bench.csv

chart: bench
	$(BUILD)/texmap chart $(BUILD)/bench.csv -o $(BUILD)/chart.svg

lesson: $(BUILD)/texmap
	@sh tests/lessons/lesson.sh $(BUILD) '$(N)'

$(BUILD)/texmap: $(BUILD)/tests/program/texmap.o $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/room: $(BUILD)/tests/program/room_main.o $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/stability: $(BUILD)/tests/stability/stability_main.o $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/readme: $(BUILD)/tests/lessons/readme_main.o $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/torture: $(BUILD)/tests/long/torture_main.o $(PROMISES) $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/test: $(BUILD)/tests/unit/test_main.o $(TEST_OBJECTS) $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(KEPT) -c -o $@ $<

$(BUILD)/%.o: %.S $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(KEPT) -c -o $@ $<

# Stage 4's own source with another distance between two divides.
$(SEGMENTS:%=$(BUILD)/stage4_subdivide/segment_%.o): $(BUILD)/stage4_subdivide/segment_%.o: \
		stage4_subdivide/rasterize.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(KEPT) -DSEGMENT_LENGTH=$(subst span,4096,$*) \
		-Dstage4_draw_triangle=segment_$*_draw_triangle -c -o $@ $<

# Stages 1 to 4 again, for `texmap trace`: there the macros of common/trace.h have a meaning.
.SECONDEXPANSION:
$(TRACED:%=$(BUILD)/trace/stage%.o): $(BUILD)/trace/stage%.o: $$(wildcard stage$$*_*/rasterize.c) \
		$(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(KEPT) -DTEXMAP_TRACE='"tests/trace/hooks.h"' -DTRACE_STAGE=$* \
		-Dstage$*_draw_triangle=trace$*_draw_triangle -c -o $@ $<

$(BUILD)/page.c: tests/page/embed.sh $(PAGE_FILES)
	@mkdir -p $(@D)
	sh $^ > $@.new && mv $@.new $@

$(BUILD)/page.o: $(BUILD)/page.c $(BUILD)/flags
	$(CC) $(CFLAGS) $(KEPT) -c -o $@ $<

# What `texmap bench` says it was built with.
$(BUILD)/tests/bench/machine.o: private KEPT += '-DTEXMAP_FLAGS="$(CFLAGS) -std=c11 -ffp-contract=off"'

# Changes when the compiler or its flags do, so that nothing built with others is kept.
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(CFLAGS) $(KEPT)' | cmp -s - $@ || echo '$(CC) $(CFLAGS) $(KEPT)' > $@

clean:
	rm -rf $(BUILD)

help:
	@sed -n 's/^#: //p' Makefile tests/long/optional.mk

#: make               build, then the main job: the room through all five stages
#: make test          every test; ends with `N passed, N failed`
#: make lesson N=2    what changed from stage 1 to stage 2, in source, picture, accuracy and speed
#: make bench         speed and accuracy of all stages on all scenes, to build/bench.csv
#: make chart         that, drawn: build/chart.svg
#: make golden        renews tests/golden/, after a change that means to move a frame
#: make build/texmap  the program alone; build/texmap help says what it can do
#: make clean         removes build/

include tests/long/optional.mk
-include $(patsubst %.o,%.d,$(SHARED) $(TEST_OBJECTS) $(MAINS:%.c=$(BUILD)/%.o) $(BUILD)/tests/program/texmap.o)
