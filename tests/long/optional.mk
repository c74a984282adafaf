# Targets that need more than a C11 compiler, make and libc. Each says clearly what it misses.

#: make report        the page on which to step through what the stages do: build/report/index.html
#: make test-page     that page in headless Chromium, held against the program's own numbers
.PHONY: report test-page
report: $(BUILD)/texmap
	$(BUILD)/texmap report -o $(BUILD)/report

test-page: $(BUILD)/texmap $(BUILD)/stability
	@sh tests/page/test.sh $(BUILD)

#: make debug         build/debug/texmap with -O0 -g, to step through a stage in gdb
.PHONY: debug
debug:
	@$(MAKE) BUILD=$(BUILD)/debug CFLAGS='-O0 -g' $(BUILD)/debug/texmap

#: make readme        the tables in the READMEs, anew from tests/results/ and the sources
.PHONY: readme
readme: $(BUILD)/texmap $(BUILD)/readme
	@TEXMAP_PROGRAM=$(BUILD)/texmap $(BUILD)/readme

#: make pictures      the pictures in the READMEs, anew
.PHONY: pictures
pictures: $(BUILD)/texmap
	@sh tests/lessons/pictures.sh $(BUILD)/texmap

#: make test-matrix   the same frames from gcc and clang at -O0 to -O3 and -Os, and -march=native
#: make test-contract a build that may fuse a*b + c draws other frames, and the tests notice
#: make test-aarch64  stages 1 to 4 on another processor: the same frames, the same exact answer
#: make sanitize      every test, built with the address and undefined behaviour sanitizers

.PHONY: test-matrix test-contract test-aarch64 sanitize

GOLDEN = long/golden_main unit/golden unit/check program/source program/options program/stages \
	exact/exact
$(BUILD)/golden: $(GOLDEN:%=$(BUILD)/tests/%.o) \
		$(patsubst %.c,$(BUILD)/%.o,$(wildcard common/*.c tests/files/*.c)) \
		$(filter-out $(BUILD)/trace/%,$(STAGE_OBJECTS))
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

test-matrix:
	@sh tests/long/same_bits.sh matrix $(BUILD)

test-contract:
	@CC='$(CC)' KEPT='$(KEPT)' sh tests/long/same_bits.sh contract $(BUILD)

test-aarch64: $(BUILD)/texmap
	@sh tests/long/same_bits.sh aarch64 $(BUILD)

SANITIZE = -fsanitize=address,undefined,float-cast-overflow,float-divide-by-zero \
	-fno-sanitize-recover=all
# A report ends the program with a status that no command has, so that a test that waits for an
# error does not take it for one.
SANITIZE_OPTIONS = exitcode=99:print_stacktrace=1

sanitize:
	@command -v clang > /dev/null || { echo 'clang is missing: Debian package clang'; exit 1; }
	@mkdir -p $(BUILD)/sanitize
	@echo 'int main(void) { return 0; }' | \
		clang $(SANITIZE) -x c -o $(BUILD)/sanitize/tried - 2> /dev/null || \
		{ echo "clang's sanitizers are missing: Debian package libclang-rt-dev"; exit 1; }
	@$(MAKE) -s BUILD=$(BUILD)/sanitize CC=clang CFLAGS='-O1 -g $(SANITIZE)' \
		$(BUILD)/sanitize/texmap $(BUILD)/sanitize/test
	@ASAN_OPTIONS=detect_leaks=1:$(SANITIZE_OPTIONS) UBSAN_OPTIONS=$(SANITIZE_OPTIONS) \
		TEXMAP_PROGRAM=$(BUILD)/sanitize/texmap $(BUILD)/sanitize/test

EXERCISE_JUDGE = $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/lessons/exercises/*.c))
EXERCISE_OBJECTS = $(EXERCISE_JUDGE) $(SHARED) $(BUILD)/tests/unit/check.o

#: make exercise N=3 E=1   an exercise of a lesson: your copy, built and judged
.PHONY: exercise
exercise: $(EXERCISE_OBJECTS)
	@CC='$(CC)' CFLAGS='$(CFLAGS) $(KEPT)' sh tests/lessons/exercise.sh $(BUILD) '$(N)' '$(E)' \
		$(EXERCISE_OBJECTS)

#: make test-exercises     are the exercises' starting points failed, and their solutions passed?
.PHONY: test-exercises
test-exercises: $(EXERCISE_OBJECTS)
	@CC='$(CC)' CFLAGS='$(CFLAGS) $(KEPT)' sh tests/lessons/exercise.sh $(BUILD) prove $(EXERCISE_OBJECTS)

#: make test-long     stage 5's assembly against stage 4's C in 100 million spans: a minute
#: make test-valgrind some of the tests under valgrind's memcheck: two minutes
.PHONY: test-long test-valgrind

test-long: $(BUILD)/test
	@TEXMAP_SPANS=100000000 $(BUILD)/test asm

test-valgrind: $(BUILD)/test
	@command -v valgrind > /dev/null || { echo 'valgrind is missing: Debian package valgrind'; exit 1; }
	@TEXMAP_SPANS=10000 valgrind -q --error-exitcode=99 --leak-check=full \
		$(BUILD)/test raster asm files clip

#: make stability     the stability table and its curves, to tests/results/
.PHONY: stability
stability: $(BUILD)/stability
	$(BUILD)/stability --csv tests/results/stability.csv --curves tests/results

#: make torture       ten million random triangles through all stages, the promises as assertions
.PHONY: torture
torture: $(BUILD)/torture
	$(BUILD)/torture --count 10000000

#: make fuzz          libFuzzer on both readers and on all stages, a minute each (FUZZ_SECONDS=60)
.PHONY: fuzz
FUZZ_SECONDS = 60
FUZZERS = tri ppm triangles
FUZZ_FLAGS = -O1 -g $(SANITIZE) -fsanitize=fuzzer-no-link

$(FUZZERS:%=$(BUILD)/fuzz_%): $(BUILD)/%: $(BUILD)/tests/long/%.o $(PROMISES) $(SHARED)
	$(CC) $(CFLAGS) -fsanitize=fuzzer -o $@ $^ $(LDLIBS)

fuzz:
	@command -v clang > /dev/null || { echo 'clang is missing: Debian package clang'; exit 1; }
	@mkdir -p $(BUILD)/fuzz
	@echo '#include <stddef.h>' > $(BUILD)/fuzz/tried.c
	@echo 'int LLVMFuzzerTestOneInput(const char *b, size_t n) { return !b && n; }' \
		>> $(BUILD)/fuzz/tried.c
	@clang -fsanitize=fuzzer -o $(BUILD)/fuzz/tried $(BUILD)/fuzz/tried.c 2> /dev/null || \
		{ echo "clang's libFuzzer is missing: Debian package libclang-rt-dev"; exit 1; }
	@$(MAKE) -s BUILD=$(BUILD)/fuzz CC=clang CFLAGS='$(FUZZ_FLAGS)' \
		$(FUZZERS:%=$(BUILD)/fuzz/fuzz_%)
	@for target in $(FUZZERS); do \
		mkdir -p $(BUILD)/fuzz/corpus/$$target && \
		$(BUILD)/fuzz/fuzz_$$target -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 \
			-artifact_prefix=$(BUILD)/fuzz/ $(BUILD)/fuzz/corpus/$$target \
			tests/long/corpus/$$target || exit 1; \
	done
