# What a person types. Each target installs what it needs first: packages of the system by apt, Python's into .venv.

run_needs = g++ cmake ninja-build
lint_needs = $(run_needs) python3-venv clang-19 clang-format-19 clang-tidy-19
test_needs = $(bench_needs) $(lint_needs) libgtest-dev pkg-config nodejs locales \
	lld-19 libclang-rt-19-dev wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 \
	qemu-user g++-aarch64-linux-gnu gfortran gnuplot-nox
bench_needs = $(run_needs) python3-venv python3-dev libbenchmark-dev libboost-dev libgsl-dev
figures_needs = $(run_needs) python3-venv python3-dev gnuplot-nox

cpp_folders = include src cli python tests bench examples
python_folders = python/pendula tests/bits tests/cli tests/package tests/python $(wildcard tests/*.py) tools bench examples

# Built under build/python, so that a second time is quick.
install_package = .venv/bin/pip install --quiet --no-build-isolation .

.PHONY: run test lint lint-cpp lint-python format sanitize golden bench figures clean
.DELETE_ON_ERROR:

# The four problems of the assignment: analysis and first rows here, whole tables in out/.
run: .stamps/run
	cmake --preset release
	cmake --build --preset release
	examples/actividad3.sh build/release/pendula examples/datosTarea_03.txt out

# All tests run even if some fail; the status tells. What they need was installed, so that a skipped test is a failure.
test: .stamps/test .stamps/venv
	cmake --preset dev
	cmake --build --preset dev
	$(install_package)
	@status=0; \
	$(MAKE) --no-print-directory --keep-going lint || status=1; \
	ctest --preset dev || status=1; \
	PENDULA_PROGRAM=build/dev/pendula .venv/bin/pytest --no-skips tests || status=1; \
	exit $$status

# What holds for the text of all sources; `make format` mends what can be mended without thinking.
lint: lint-cpp lint-python

lint-cpp: .stamps/lint
	@find $(cpp_folders) -name '*.[ch]pp' | xargs clang-format-19 --dry-run --Werror
	@cmake --preset lint >/dev/null
	@run-clang-tidy-19 -quiet -p build/lint '/(src|cli)/[^.]*\.cpp$$' >build/lint/report 2>&1 || \
		{ grep -vE '^\[ *[0-9]+/|warnings? generated|^$$' build/lint/report; exit 1; }

lint-python: .stamps/venv
	@.venv/bin/ruff check --quiet
	@.venv/bin/ruff format --quiet --check
	@for each in $(python_folders); do .venv/bin/mypy --no-error-summary $$each || exit 1; done

format: .stamps/lint .stamps/venv
	find $(cpp_folders) -name '*.[ch]pp' | xargs clang-format-19 -i
	.venv/bin/ruff check --quiet --fix --exit-zero
	.venv/bin/ruff format --quiet

# Address and undefined-behaviour sanitizers over the C++ tests, then a minute of fuzzing the reader.
sanitize: .stamps/test
	cmake --workflow --preset sanitize
	build/sanitize/fuzz_reader -max_total_time=60 -print_final_stats=1

# After an intended change of results, and a line in the changelog's section Numerics.
golden: .stamps/test
	python3 tests/bits/builds.py
	git --no-pager diff --stat tests/bits/golden.txt

# pendula beside its peers, on an otherwise idle machine; some minutes.
bench: .stamps/bench .stamps/peers
	cmake --preset bench
	cmake --build --preset bench
	$(install_package)
	.venv/bin/python bench/report.py build/bench docs/benchmarks.md

figures: .stamps/figures run
	mkdir -p docs/figures
	gnuplot -c examples/actividad3.gp docs/figures/actividad3.svg
	python3 -m venv .venv
	.venv/bin/pip install --quiet '.[plot]'
	mkdir -p docs/gallery
	for script in examples/gallery/*.py; do \
		MATPLOTLIBRC=examples/gallery SOURCE_DATE_EPOCH=0 .venv/bin/python $$script docs/gallery || exit 1; \
	done

clean:
	rm -rf build out .venv .stamps

.stamps/venv: tests/requirements.txt .stamps/lint
	python3 -m venv .venv
	.venv/bin/pip install --quiet uv
	UV_PYTHON_DOWNLOADS=never .venv/bin/uv pip install --quiet --python .venv/bin/python --requirement tests/requirements.txt
	touch $@

.stamps/peers: bench/requirements.txt .stamps/bench
	python3 -m venv .venv
	.venv/bin/pip install --quiet --requirement bench/requirements.txt
	touch $@

.stamps/%: Makefile .ci/need
	.ci/need $($*_needs)
	mkdir -p .stamps
	touch $@
