# What a person types. Each target installs what it needs first: packages of the system by apt, Python's into .venv.

run_needs = g++ cmake ninja-build
test_needs = $(bench_needs) libgtest-dev pkg-config nodejs \
	clang-19 lld-19 libclang-rt-19-dev wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 \
	qemu-user g++-aarch64-linux-gnu gnuplot-nox
bench_needs = $(run_needs) python3-venv libbenchmark-dev libboost-dev libgsl-dev
figures_needs = $(run_needs) python3-venv gnuplot-nox

# Built under build/python, so that a second time is quick.
install_package = .venv/bin/pip install --quiet --no-build-isolation .

.PHONY: run test sanitize golden bench figures clean
.DELETE_ON_ERROR:

# The four problems of the assignment: analysis and first rows here, whole tables in out/.
run: .stamps/run
	cmake --preset release
	cmake --build --preset release
	examples/actividad3.sh build/release/pendula examples/datosTarea_03.txt out

# All tests run even if some fail; the status tells.
test: .stamps/test .stamps/venv
	cmake --preset dev
	cmake --build --preset dev
	$(install_package)
	@status=0; \
	ctest --preset dev || status=1; \
	PENDULA_PROGRAM=build/dev/pendula .venv/bin/pytest tests || status=1; \
	exit $$status

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

.stamps/venv: tests/requirements.txt .stamps/test
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
