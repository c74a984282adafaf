# texmap: perspective texture mapping in five stages. `make help` lists the targets.
# Needs a C11 compiler, make and libc. CC and CFLAGS may be given on the command line.

MAKEFLAGS += -r # no built-in rules: all are below
BUILD = build
CFLAGS = -O2
# Kept whatever CFLAGS say: without them another compiler or processor draws other bits.
KEPT = -std=c11 -ffp-contract=off -Wall -Wextra -Wpedantic -I. -MMD -MP
LDLIBS = -lm

STAGES = stage1_float stage2_dda stage3_fixed28_4 stage4_subdivide
ifneq ($(findstring x86_64,$(shell $(CC) -dumpmachine 2>/dev/null)),)
STAGES += stage5_asm
ASM = span
endif
SEGMENTS = 4 8 32 64 span

COMMON_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c))
STAGE_OBJECTS = $(STAGES:%=$(BUILD)/%/rasterize.o) $(ASM:%=$(BUILD)/stage5_asm/%.o) \
	$(SEGMENTS:%=$(BUILD)/stage4_subdivide/segment_%.o)
TEST_SOURCES = $(wildcard tests/test*.c tests/check.c tests/cli.c tests/padded.c tests/png_decode.c)
TEST_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(TEST_SOURCES))
HARNESS_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,\
	$(filter-out tests/texmap.c $(TEST_SOURCES),$(wildcard tests/*.c)))
SHARED = $(COMMON_OBJECTS) $(STAGE_OBJECTS) $(HARNESS_OBJECTS)

.PHONY: all test clean help
all: $(BUILD)/texmap

$(BUILD)/texmap: $(BUILD)/tests/texmap.o $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/test: $(TEST_OBJECTS) $(SHARED)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

test: $(BUILD)/texmap $(BUILD)/test
	$(BUILD)/test

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

# Changes when the compiler or its flags do, so that nothing built with others is kept.
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(CFLAGS) $(KEPT)' | cmp -s - $@ || echo '$(CC) $(CFLAGS) $(KEPT)' > $@
.PHONY: FORCE

clean:
	rm -rf $(BUILD)

-include $(patsubst %.o,%.d,$(SHARED) $(TEST_OBJECTS) $(BUILD)/tests/texmap.o)
