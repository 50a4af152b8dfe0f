# What a release must pass beyond `make test`: the package in other people's tools, how much the tests run, what they notice. Included by Makefile.

.PHONY: packages valgrind coverage mutants release-check

# C files that every native test links with.
NATIVE_SHARED := $(filter-out %_test.c,$(wildcard tests/native/*.c))

# The package in other people's tools. Each consumer's tools come from its own lockfile, into build/packages/.

packages: all ## install the packed package in Node, Deno, Bun, bundlers, pages and TypeScript, and run it
	@node tests/package/packages.js

# The native tests without sanitizers, each under valgrind.

VALGRIND_TESTS := $(patsubst tests/native/%_test.c,build/plain/%_test,$(wildcard tests/native/*_test.c))

build/plain/%.o: %.c tests/release.mk | tools
	@mkdir -p $(@D)
	@gcc $(CFLAGS) -O1 -g -c $< -o $@

build/plain/%_test: build/plain/tests/native/%_test.o $(NATIVE_SHARED:%.c=build/plain/%.o) $(WASM:%.c=build/plain/%.o)
	@gcc $^ -lm -o $@

valgrind: $(VALGRIND_TESTS) | tools ## run the native tests under valgrind (minutes)
	@for test in $^; do echo $$test; valgrind --quiet --error-exitcode=9 --leak-check=full $$test tests/data >/dev/null || exit 1; done

# Coverage: the C is compiled twice with clang's counters, into the WebAssembly that the unit tests then run and into the native tests.

COVERED := -std=c17 -ffp-contract=off -fno-math-errno -Iwasm -MMD -MP -fprofile-instr-generate -fcoverage-mapping
COVERAGE_TESTS := $(patsubst tests/native/%_test.c,build/coverage/%_test,$(wildcard tests/native/*_test.c))
COUNTERS := coverage_functions coverage_function_count coverage_names coverage_name_count

build/coverage/wasm/%.o: wasm/%.c tests/release.mk | tools
	@mkdir -p $(@D)
	@emcc $(COVERED) -O1 -msimd128 -mbulk-memory -DNDEBUG -mllvm -enable-name-compression=false -c $< -o $@

build/coverage/counters.o: tests/coverage/counters.c | tools
	@mkdir -p $(@D)
	@emcc -std=c17 -O1 -c $< -o $@

build/coverage/surfpath.wasm: $(WASM:%.c=build/coverage/%.o) build/coverage/counters.o wasm/surfpath.exports
	@emcc $(LINK) -sEXPORTED_FUNCTIONS=$$(echo $$(cat wasm/surfpath.exports) $(COUNTERS) | sed 's/[^ ]*/_&/g; s/ /,/g') $(filter %.o,$^) -o $@

build/coverage/native/%.o: %.c tests/release.mk | tools
	@mkdir -p $(@D)
	@clang $(COVERED) -O1 -fPIC -DNDEBUG -c $< -o $@

build/coverage/core.so: $(WASM:%.c=build/coverage/native/%.o)
	@clang -shared -fprofile-instr-generate $^ -o $@

build/coverage/%_test: tests/native/%_test.c $(NATIVE_SHARED) $(WASM:%.c=build/coverage/native/%.o)
	@clang -std=c17 -ffp-contract=off -fno-math-errno -Iwasm -O1 -fprofile-instr-generate $^ -lm -o $@

# But for tests of what was built, and of how much memory it takes, which counters are a part of.
COUNTED := find tests/unit -name '*.test.js' ! -name build.test.js ! -name memory-limits.test.js

coverage: all build/native/core.o build/coverage/surfpath.wasm build/coverage/core.so $(COVERAGE_TESTS) ## branches of the C and lines of the JavaScript that the tests run; 95 % of each are wanted
	@rm -rf build/coverage/counters build/coverage/v8 build/coverage/*.prof*
	@for test in $(COVERAGE_TESTS); do LLVM_PROFILE_FILE=$$test.profraw $$test tests/data >/dev/null || exit 1; done
	@NODE_OPTIONS=--import=$(CURDIR)/tests/coverage/preload.js NODE_V8_COVERAGE=build/coverage/v8 \
	    node --test --test-reporter=dot --test-timeout=300000 $$($(COUNTED) | sort)
	@NODE_OPTIONS=--import=$(CURDIR)/tests/coverage/pages.js \
	    node --test --test-reporter=dot --test-timeout=300000 --test-concurrency=1 tests/browser/element.test.js tests/browser/three.test.js
	@node tests/coverage/merge.js build/coverage/counters >build/coverage/wasm.proftext
	@llvm-profdata merge -o build/coverage/all.profdata build/coverage/*.profraw build/coverage/wasm.proftext
	@llvm-cov export build/coverage/core.so -instr-profile=build/coverage/all.profdata >build/coverage/branches.json
	@failed=0; node tests/coverage/c.js 95 <build/coverage/branches.json || failed=1; \
	    node tests/coverage/javascript.js build/coverage/v8 95 || failed=1; exit $$failed

# Mistakes put into the sources, one at a time. Written in JavaScript: tests/mutants/.

mutants: all $(NATIVE_TESTS) | tools ## put small mistakes into the sources and see whether the tests notice (half an hour)
	@SANITIZED='$(SANITIZED)' node tests/mutants/mutants.js

# Those of the list that some makefile here defines.

RELEASE := test samples tidy coverage golden packages browsers mutants accuracy endurance bench fuzz
DEFINED := $(shell sed -n 's/^\([a-z]*\):.*/\1/p' Makefile tests/*.mk)

release-check: ## run all of it, one after the other, and print one table
	@node tests/release.js $(filter $(DEFINED),$(RELEASE))
