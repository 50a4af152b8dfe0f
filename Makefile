# Builds dist/ from wasm/ (C, by emcc) and web/ (JavaScript, by esbuild), and checks it. Tools that are missing are installed first.
# `make help` lists the targets.

CORES := $(shell nproc 2>/dev/null || echo 1)
MAKEFLAGS += --no-builtin-rules --no-print-directory -j$(CORES)
# Several goals one after the other: `make clean test`.
ifneq ($(word 2,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: all test samples browsers check tidy bench bench-peers accuracy fuzz endurance golden golden-update site thumbnails demo format clean help tools

ENTRIES := index slim gallery pool
VIEWS := three element
WASM := $(wildcard wasm/*.c)
WEB := $(shell find web -name '*.js')
NATIVE_TESTS := $(patsubst tests/native/%_test.c,build/sanitized/%_test,$(wildcard tests/native/*_test.c))
NATIVE_HELPERS := $(patsubst tests/native/%.c,build/sanitized/tests/%.o,$(filter-out %_test.c,$(wildcard tests/native/*.c)))
C_FILES := $(wildcard wasm/*.[ch] wasm/pack/*.c tests/native/*.[ch] tests/bench/*.[ch] tests/fuzz/*.[ch] tests/golden/*.[ch] tests/coverage/*.c)
FUZZERS := expressions definitions straight global
BIN := node_modules/.bin
NPM := node_modules/.package-lock.json

# One set of flags for every compiler. No contraction into fused operations: the same bits everywhere.
CFLAGS := -std=c17 -Wall -Wextra -Wconversion -Wdouble-promotion -Werror -ffp-contract=off -fno-math-errno -Iwasm -MMD -MP
# -O2, without what makes code longer but not faster here: unrolled and vectorised loops, inlining, expressions computed ahead on every way.
# Conversions that do not trap are one instruction instead of a test of the range; what has SIMD has them.
EMCC := emcc $(CFLAGS) -O2 -fno-unroll-loops -fno-vectorize -fno-slp-vectorize -mllvm -enable-pre=0 -mllvm -enable-gvn-hoist -msimd128 \
    -mbulk-memory -mnontrapping-fptoint -DNDEBUG
NATIVE := gcc $(CFLAGS) -O3 -DNDEBUG
SANITIZED := gcc $(CFLAGS) -O2 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
# NULL + 0, which C17 leaves undefined and every compiler defines, is no finding.
FUZZED := clang $(CFLAGS) -O2 -g -fno-omit-frame-pointer -fsanitize=fuzzer,address,undefined -fno-sanitize=pointer-overflow \
    -fno-sanitize-recover=all
# The analyzer takes a vector of 64-bit lanes for one bit.
ANALYZER := gcc $(CFLAGS) -O1 -fanalyzer -Wno-analyzer-shift-count-overflow
LINK := -sSTANDALONE_WASM --no-entry -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=1MB -sTOTAL_STACK=128KB \
    -Wl,--export-table -Wl,--growable-table

# What each goal needs beyond Node and npm, as probe:package.
needs = $(if $(filter $(1),$(MAKECMDGOALS)),$(2))
TOOLS := emcc:emscripten wasm-opt:binaryen zopfli:zopfli \
    $(call needs,test samples bench mutants tidy valgrind golden,gcc:gcc /usr/include/stdio.h:libc6-dev) \
    $(call needs,test check format,clang-format:clang-format) \
    $(call needs,test packages thumbnails coverage browsers golden,chromium:chromium) \
    $(call needs,browsers golden,firefox-esr:firefox-esr WebKitWebDriver:webkit2gtk-driver Xvfb:xvfb) \
    $(call needs,tidy valgrind,cppcheck:cppcheck clang-tidy:clang-tidy valgrind:valgrind) \
    $(call needs,coverage,llvm-cov:llvm) \
    $(call needs,test samples fuzz golden coverage,clang:clang /usr/share/doc/libclang-rt-dev:libclang-rt-dev)

# How long each fuzzer of `make fuzz` runs.
SECONDS ?= 60

all: dist/surfpath.wasm $(ENTRIES:%=dist/%.js) dist/worker.js $(VIEWS:%=dist/%.js) dist/types/index.d.ts ## build dist/ (the default)

test: all site check $(NATIVE_TESTS) build/native/core.o build/march/core.o build/named.wasm build/fuzz/core ## build, check, and run every test
	@node --test --test-reporter=spec --test-timeout=300000 --test-concurrency=$(CORES) $$(find tests -name "*.test.js" ! -path "tests/browser/*" | sort)
	@node --test --test-reporter=spec --test-timeout=300000 $$(find tests/browser -name "*.test.js" | sort)

samples: all $(NATIVE_TESTS) build/native/core.o build/march/core.o build/named.wasm build/fuzz/core ## every test but those in browsers, all of it, where test has a sample (slow)
	@EVERY_SAMPLE=1 node --test --test-reporter=spec --test-timeout=600000 --test-concurrency=$(CORES) $$(find tests -name "*.test.js" ! -path "tests/browser/*" | sort)

browsers: all site ## the page in Chromium, Firefox and WebKit: everything, where test has a sample (slow)
	@EVERY_RELEASE=1 node --test --test-reporter=spec --test-timeout=600000 --test-concurrency=1 $$(find tests/browser tests/browsers -name "*.js" | sort)

check: dist/types/index.d.ts $(NPM) | tools ## formatting, lint and types
	@$(BIN)/biome check --colors=off --error-on-warnings
	@$(BIN)/tsc -p tests
	@$(BIN)/tsc -p demo
	@clang-format --dry-run -Werror $(C_FILES)

tidy: | tools ## look for mistakes in the C with gcc's analyzer, cppcheck, clang-tidy and valgrind (slow, so not part of check)
	@for file in $(WASM); do $(ANALYZER) -c $$file -o /dev/null || exit 1; done
	@cppcheck --std=c11 --enable=warning,performance,portability,style --suppressions-list=.cppcheck -Iwasm --quiet --error-exitcode=1 wasm
	@clang-tidy --quiet $(WASM) -- -std=c17 -Iwasm 2>/dev/null
	@$(MAKE) valgrind

bench: all build/native/core.o build/march/core.o build/named.wasm ## run the benchmarks
	@set -e; for file in $(sort $(wildcard tests/bench/*.bench.js)); do node $$file; done

bench-peers: all ## compare with scipy, CGAL and GeographicLib, which it installs
	@tests/helpers/install.sh g++:g++ /usr/include/CGAL/Surface_mesh_shortest_path.h:libcgal-dev /usr/lib/python3/dist-packages/scipy:python3-scipy
	@mkdir -p build/peers
	@cp .npmrc tests/bench/peers/npm/*.json build/peers/
	@cd build/peers && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error </dev/null >/dev/null
	@g++ -std=c++17 -O3 -DNDEBUG tests/bench/peers/mesh.cpp -o build/peers/mesh -lgmp -lmpfr
	@node tests/bench/peers/peers.js

accuracy: all ## print the tables of what is found, and how exactly (slow)
	@failed=0; for file in $(sort $(wildcard tests/accuracy/*.js)); do node $$file || failed=1; done; exit $$failed

fuzz: all build/fuzz/core ## fuzz for SECONDS=60 each, and keep what is new in tests/fuzz/corpus
	@set -e; for name in $(FUZZERS); do KEEP=1 node tests/fuzz/fuzz.js $$name $(SECONDS); done
	@build/fuzz/core -max_total_time=$(SECONDS) -timeout=250 -max_len=400 -len_control=0 -artifact_prefix=build/fuzz/ tests/fuzz/corpus/core
	@node tests/fuzz/fuzz.js straight 86400 1 1000000
	@node tests/fuzz/fuzz.js global 86400 2 10000

endurance: all ## what a million solves, 10,000 surfaces and 10,000 instances leave in memory (slow)
	@node --expose-gc tests/endurance/memory.js

golden: all ## the same bits in Node 20 and 22, three browsers, gcc and clang at every level; the same .wasm twice (slow)
	@node tests/golden/golden.js

golden-update: all ## store the present bits as the golden ones
	@node tests/golden/golden.js update

site: build/site/main.js ## build the demonstration page as static files in build/site, for any server and any folder

thumbnails: site ## render the gallery's pictures anew, with the page itself
	@node demo/make-thumbnails.js

demo: site ## build, serve the page on a free loopback port and print its address
	@node demo/serve.js

format: $(NPM) | tools ## format every source
	@$(BIN)/biome check --write --log-level=warn
	@clang-format -i $(C_FILES)

clean: ## remove what was built
	@rm -rf build dist

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' Makefile tests/release.mk | expand -t 16

tools:
	@tests/helpers/install.sh $(TOOLS)

# The packages' own install scripts are not needed, and newer npm does not run them.
$(NPM): package-lock.json | tools
	@echo 'installing with npm: what package-lock.json lists'
	@npm ci --ignore-scripts --include=dev --no-audit --no-fund --loglevel=error </dev/null >/dev/null
	@touch $@

# WebAssembly

# What a path meets once is compiled to be small; what every step meets, and what that does not make shorter, with little inlining.
# Loops do not begin with a copy of their test, unless that is short.
LEVEL := -Os -mllvm -rotation-max-header-size=2
HOT := blocks chart check dop853 elements elements_condense energy functions_constants functions_exponential functions_inverse functions_trigonometric \
    graph_front graph_implicit graph_parametric graph_sample implicit mesh_vertices metric_check metric_elements parametric parametric_metric \
    reference sample stride
$(HOT:%=build/wasm/%.o): LEVEL := -mllvm -rotation-max-header-size=4 -mllvm -inline-threshold=5
# As fast as with -Os, and shorter.
SMALLEST := flow graph_search memory mesh newton project refine refine_chords
$(SMALLEST:%=build/wasm/%.o): LEVEL := -Oz
# With -Os and -Oz emcc leaves all inlining to wasm-opt. Here it is shorter where the compiler inlines what a call would not be shorter than.
INLINED := bridge flow hole memory mesh newton project refine start trace
$(INLINED:%=build/wasm/%.o): LEVEL += -finline-functions -mllvm -inline-threshold=-30

# A constant is loaded into both lanes by one instruction; combined with others it is loaded as two, and shuffled.
$(filter build/wasm/functions%,$(WASM:%.c=build/%.o)): LEVEL += -mllvm -disable-vector-combine

build/wasm/%.o: wasm/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(EMCC) $(LEVEL) -c $< -o $@

EXPORTS = -sEXPORTED_FUNCTIONS=$$(sed 's/^/_/' wasm/surfpath.exports | paste -sd, -)
BINARYEN := --enable-simd --enable-bulk-memory --enable-sign-ext --enable-mutable-globals --enable-nontrapping-float-to-int

# What the linker made, once more by wasm-opt, and its constants shortened. $(1): -g keeps names.
define shrink
@wasm-opt $(BINARYEN) $(1) --low-memory-unused -Oz -S $@ -o $@.wat
@node wasm/shorten.js $@.wat
@wasm-as $(BINARYEN) $(1) $@.wat -o $@
@wasm-opt $(BINARYEN) $(1) -ol 2 -s 2 --remove-unused-module-elements --generate-stack-ir --optimize-stack-ir $@ -o $@
@rm $@.wat
endef

dist/surfpath.wasm: $(WASM:%.c=build/%.o) wasm/surfpath.exports wasm/shorten.js Makefile
	@echo $@
	@mkdir -p $(@D)
	@$(EMCC) -Oz $(LINK) $(EXPORTS) $(filter %.o,$^) -o $@
	$(call shrink)

# The same with the names of its functions, for profiles.
build/named.wasm: $(WASM:%.c=build/%.o) wasm/surfpath.exports wasm/shorten.js Makefile
	@$(EMCC) -Oz $(LINK) --profiling-funcs $(EXPORTS) $(filter %.o,$^) -o $@
	$(call shrink,-g)

# JavaScript and types

# What puts the packed module together: without the exports that the linker adds.
build/pack/regroup.wasm: wasm/pack/regroup.c Makefile | tools
	@mkdir -p $(@D)
	@$(EMCC) -Oz $(LINK) -sTOTAL_STACK=4KB -sINITIAL_MEMORY=64KB -sEXPORTED_FUNCTIONS=_regroup $< -o $@
	@wasm-opt $(BINARYEN) -Oz -S $@ -o $@.wat
	@sed -i '/(export "/{/"memory"\|"regroup"/!d}' $@.wat
	@wasm-as $(BINARYEN) $@.wat -o $@
	@wasm-opt $(BINARYEN) -Oz --remove-unused-module-elements $@ -o $@
	@rm $@.wat

dist/wasm.js: dist/surfpath.wasm build/pack/regroup.wasm wasm/pack/pack.js web/runtime/unpack.js
	@node wasm/pack/pack.js $< build/pack/regroup.wasm $@

dist/wasm.d.ts: Makefile
	@mkdir -p $(@D)
	@printf 'declare const text: string;\nexport default text;\n' >$@

BUNDLE = $(BIN)/esbuild $< --bundle --minify --format=esm --target=es2022 '--external:node:*' --log-level=warning --outfile=$@
# Once more, in 4 % fewer bytes: the module's text stays in front, where it compresses best (wasm/pack/pack.js), and lines are short enough to stand above an
# error: they end where statements do, else a semicolon and a line's end would both stand there; no function is a constructor, no getter does anything but get.
SHORTER = --module --ecma 2022 --compress passes=5,inline=1,unsafe_arrows,pure_getters --mangle
SHORTEN = $(BIN)/terser $@ $(SHORTER) --format max_line_len=500,semicolons=false --output $@

# Properties with these names, or names as isPlain, are of no object that a caller, a worker or another entry gets: their names get short.
INNER = signs|integerPower|legs|joints|shore|crease|sides|numberOf|valueOrder|(write|copy|all)(Doubles|Words|Point|Records?)|arenaBase|openArena|steepness|readPoint|negativeZero|halfWave|whereNonzero|signFrom|placeAt|sketch|building|isPlain|branches|isAtRest|isCorner|valueAt|outputs|isCreased|invalidate|tensors|endProblem|shadeProblem|moving|isUnique|isDisposed|isSlow|isEdge|isMinimum|isLeg|isRelaxed|isFixed|isSpatial|isBrief|isOneSided|budget|route|moved|coarse|determinant|partsAt|writeParameters|candidates|measureField|pulls|chords|velocity|exactness|jets|work|graphs|pinches|largest|passage|folds|finest|tips|steps|balanced|slabs|signAt|poles|slopes|crossings|leg|aside|moves|measured|sense|floors|factor|rough|halves|dearer|shores|ways|missed|generation|widths|trail|creases|written|again|beyond|parts|across|place|places|spanned|flattened|pullBack|findAround|findSmooth|equate|into|followed|edgeOf|corners|_onChangeCallback|_targetRay|_normalizationScale|_(equirect|cubemap|ggx|integration|blur)Material|_spherical(Delta)?|_getSecondPointerPosition|_pointer(Position)?s
# On the page these gain nothing.
FEW = squareRoot|operands|precedence|uninstall|installAll|releaseGraph|meshImplicit
dist/index.js dist/slim.js dist/worker.js: SHORTER += --mangle-props 'regex=/^(is[A-Z].*|$(FEW)|$(INNER))$$/'

# The pool shares the default entry's file with the rest of a page, and so its classes.
dist/pool.js: BUNDLE += '--external:./index.*'

$(ENTRIES:%=dist/%.js): dist/%.js: web/%.js $(WEB) dist/wasm.js Makefile $(NPM)
	@echo $@
	@$(BUNDLE)
	@$(SHORTEN)

dist/worker.js: web/runtime/worker.js $(WEB) dist/wasm.js Makefile $(NPM)
	@echo $@
	@$(BUNDLE)
	@$(SHORTEN)

# Used with the reader's own three.js; and the element with the entries beside it in dist/, which a page has once whoever imports them.
$(VIEWS:%=dist/%.js): dist/%.js: web/view/%.js $(WEB) Makefile $(NPM)
	@echo $@
	@$(BUNDLE) --external:three '--external:*/index.js' '--external:*/gallery.js' '--external:*/three.js'
	@sed -i -E 's#"(\.\./)+(index|gallery|three)\.js"#"./\2.js"#g' $@
	@$(SHORTEN)

dist/types/index.d.ts: $(WEB) web/view/globals.d.ts tsconfig.json tests/helpers/prune-types.js dist/wasm.d.ts $(NPM)
	@echo $(@D)
	@rm -rf $(@D)
	@$(BIN)/tsc -p .
	@sed -n '/^declare/,$$p' web/view/globals.d.ts >>$(@D)/view/element.d.ts
	@node tests/helpers/prune-types.js $(@D)
	@touch $@

# The page: one bundle for the window and its worker, which share most of it; what is asked for later is a file of its own. Everything is named
# relative to everything else. The largest file is three.js, whose functions may be constructors: terser takes 5 s for 3.7 KB of its 137, some of
# it as no getter there does anything but get.

build/site/main.js: $(shell find demo -type f) dist/wasm.js $(WEB) Makefile $(NPM)
	@echo $(@D)
	@rm -rf $(@D)
	@mkdir -p $(@D)
	@$(BIN)/esbuild demo/main.js demo/worker.js demo/style.css --bundle --splitting --minify --format=esm --target=es2022 \
	    --alias:surfpath=./web/index.js --alias:surfpath/gallery=./web/gallery.js --alias:surfpath/three=./web/view/three.js '--external:node:*' '--mangle-props=^($(INNER))$$' --log-level=warning --outdir=$(@D)
	@cd $(@D) && largest=$$(ls -S *.js | head -1) && ls *.js | grep -v $$largest | xargs -P2 -I{} $(CURDIR)/$(BIN)/terser {} $(SHORTER) --output {} && \
	    $(CURDIR)/$(BIN)/terser $$largest --module --ecma 2022 --compress passes=2,pure_getters --mangle --output $$largest
	@sed 's/^ *//' demo/index.html >$(@D)/index.html
	@cp -r demo/icon.svg demo/thumbnails $(@D)

# Native builds of the same C: with sanitizers for the tests; optimised, one object, for benchmarks and the symbol check.

build/sanitized/wasm/%.o: wasm/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(SANITIZED) -c $< -o $@

build/sanitized/tests/%.o: tests/native/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(SANITIZED) -c $< -o $@

build/fuzz/wasm/%.o: wasm/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(FUZZED) -c $< -o $@

build/fuzz/tests/%.o: tests/fuzz/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(FUZZED) -c $< -o $@

build/fuzz/core: build/fuzz/tests/core_fuzz.o build/fuzz/tests/hostile.o $(WASM:%.c=build/fuzz/%.o)
	@$(FUZZED) $^ -o $@

build/sanitized/%_test: build/sanitized/tests/%_test.o $(NATIVE_HELPERS) $(WASM:%.c=build/sanitized/%.o)
	@$(SANITIZED) $^ -lm -o $@

build/native/wasm/%.o: wasm/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(NATIVE) -c $< -o $@

# Which loops gcc sees through differs by processor, and with it what it takes for uninitialised: build/native judges that.
build/march/wasm/%.o: wasm/%.c Makefile | tools
	@mkdir -p $(@D)
	@$(NATIVE) -march=native -Wno-maybe-uninitialized -c $< -o $@

build/native/core.o: $(WASM:%.c=build/native/%.o)
	@ld -r $^ -o $@

build/march/core.o: $(WASM:%.c=build/march/%.o)
	@ld -r $^ -o $@

include tests/release.mk

-include $(wildcard build/*/*.d build/*/*/*.d build/*/*/*/*.d)
