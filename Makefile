# make demo     install into .venv and lint the sample robots
# make test     run the tests
# make check    everything that must hold before a commit
# make generate write the generated files again;  make golden: the expected outputs;  make bench: the speed table

PYTHON ?= python3
VENV ?= .venv
BENCH_VENV ?= build/bench-venv

BIN := $(VENV)/bin
PIP_INSTALL := -m pip install --quiet --disable-pip-version-check
RUNTIME := $(VENV)/.installed
TOOLS := $(VENV)/.installed-dev

.PHONY: demo test check layers format format-check lint types generate generated golden bench clean

demo: $(RUNTIME)
	$(BIN)/sdfcheck lint --exit-zero fixtures/robots

test: $(TOOLS)
	$(BIN)/python -m pytest

check: format-check lint types layers generated test

layers: $(TOOLS)
	$(BIN)/python -m pytest -q -n0 tests/test_layers.py tests/test_style.py

format: $(TOOLS)
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix-only --quiet .

format-check: $(TOOLS)
	$(BIN)/ruff format --check .

lint: $(TOOLS)
	$(BIN)/ruff check .

types: $(TOOLS) build/mypy/sdfcheck_rules
	$(BIN)/mypy

generate: $(TOOLS)
	$(BIN)/python -m sdfcheck.lint.rulebook.index
	$(BIN)/python -m sdfcheck.lint.rulebook.conditions
	$(BIN)/python -m sdfcheck.lint.rulebook.manual_pages
	$(BIN)/python -m sdfcheck.convert.loss_table

generated: $(TOOLS)
	$(BIN)/python -m sdfcheck.lint.rulebook.index --check
	$(BIN)/python -m sdfcheck.lint.rulebook.conditions --check
	$(BIN)/python -m sdfcheck.lint.rulebook.manual_pages --check
	$(BIN)/python -m sdfcheck.convert.loss_table --check

golden: $(TOOLS)
	$(BIN)/python -m pytest -q -n0 tests/test_golden*.py --golden

# Measures an ordinary installation: an editable one starts slower.
bench: pyproject.toml setup.py
	[ -x $(BENCH_VENV)/bin/python ] || $(PYTHON) -m venv $(BENCH_VENV)
	rm -rf build/lib build/bdist.*
	$(BENCH_VENV)/bin/python $(PIP_INSTALL) .
	$(BENCH_VENV)/bin/python $(PIP_INSTALL) --force-reinstall --no-deps .
	$(BENCH_VENV)/bin/python -m benchmarks.run

$(RUNTIME): pyproject.toml setup.py
	[ -x $(BIN)/python ] || $(PYTHON) -m venv $(VENV)
	$(BIN)/python $(PIP_INSTALL) --editable .
	touch $@

$(TOOLS): $(RUNTIME)
	$(BIN)/python $(PIP_INSTALL) --editable '.[dev]'
	touch $@

# mypy finds the rules under the name that they are imported by.
build/mypy/sdfcheck_rules:
	mkdir -p $(@D)
	ln -sfn ../../rules $@

clean:
	rm -rf $(VENV) build .mypy_cache .pytest_cache .ruff_cache .hypothesis
