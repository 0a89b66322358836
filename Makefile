# make demo     install into .venv and lint the sample robots
# make tools    install what the checks and the documentation need
# make test     run the tests
# make quick    run the tests of units and rules that are quick, for the loop of editing and testing
# make check    everything that must hold before a commit
# make docs     build the documentation site into build/site; broken links are errors
# make package  build the source distribution and the wheel into build/dist, and try both
# make man      write the manual page build/man/sdfcheck.1
# make publish-site  build the site of this release into the branch gh-pages, beside those of others; PUSH=--push sends it
# make release-check  try both distributions in empty environments, with each Python from 3.10 on that is installed
# make vscode   test, compile and package the extension for Visual Studio Code (needs node); vscode-check: only test
# make picture  draw the terminal and the badges of the README again
# make viewer   check and build the scripts of the pages for browsers, from viewer/ (needs node); viewer-check: only check
# make gallery  draw the pictures of docs/gallery.md again (needs Chromium)
# make fuzz     run every command on texts that nobody would write, for MINUTES from SEED
# make growth   measure how the work of the commands grows with the size of a document
# make mutants  change the code a little, many times: which changes does no test notice?
# make engines  ask Drake, MuJoCo and PyBullet, as far as they can be installed here
# make reactions measure what consumers do with the examples of rules, for consumers/data/reactions.txt
# make generate write the generated files again;  make golden: the expected outputs;  make bench: the speed table

PYTHON ?= python3
CONSTRAINTS := .ci/constraints.txt
VENV ?= .venv
MINUTES ?= 10
SEED ?= 1
PLATFORM ?= win32
PYTHONS ?= $(HOME)/.pyenv/versions
BENCH_VENV ?= build/bench-venv

BIN := $(VENV)/bin
PIP_INSTALL := -m pip install --quiet --disable-pip-version-check
RUNTIME := $(VENV)/.installed
TOOLS := $(VENV)/.installed-dev
SITE_TOOLS := $(VENV)/.installed-docs
CONDITIONS := rules/conditions.py
RULES := $(shell find rules -name '*.py' ! -path '$(CONDITIONS)')

.PHONY: demo compiled tools man publish-site versions release-check picture test quick check layers format format-check lint types types-of-platform generate generated reactions golden docs package lowest newest vscode vscode-check viewer viewer-check gallery bench engines growth fuzz mutants clean

demo: compiled
	$(BIN)/sdfcheck lint --exit-zero fixtures/robots

tools: $(TOOLS) $(SITE_TOOLS)

test: $(TOOLS) compiled
	$(BIN)/python -m pytest

quick: $(TOOLS) compiled
	$(BIN)/python -m pytest -m "not slow" tests/unit tests/test_rules.py

check: format-check lint types generated test

layers: $(TOOLS)
	$(BIN)/python -m pytest -q -n0 tests/test_layers.py tests/test_style.py

format: $(TOOLS)
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix-only --quiet .
	$(BIN)/python -m tables.fold_pages

format-check: $(TOOLS)
	$(BIN)/ruff format --check .

lint: $(TOOLS)
	$(BIN)/ruff check .

types: $(TOOLS) $(CONDITIONS) build/mypy/sdfcheck_rules
	$(BIN)/mypy

# What Python and the system have elsewhere: PLATFORM is linux, darwin or win32.
types-of-platform: $(TOOLS) $(CONDITIONS) build/mypy/sdfcheck_rules
	$(BIN)/mypy --platform $(PLATFORM) --no-warn-unreachable sdfcheck build/mypy/sdfcheck_rules

generate: $(TOOLS) $(CONDITIONS)
	$(BIN)/python -m sdfcheck.lint.rulebook.index
	$(BIN)/python -m tables.rule_pages
	$(BIN)/python -m tables.loss_table
	$(BIN)/python -m tables.fold_pages

generated: $(TOOLS) $(CONDITIONS)
	$(BIN)/python -m sdfcheck.lint.rulebook.index --check
	$(BIN)/python -m tables.rule_pages --check
	$(BIN)/python -m tables.loss_table --check

# In an environment of their own, as they need other versions; without a wheel for this Python they are left out.
engines: $(TOOLS)
	[ -x build/engines/bin/python ] || $(PYTHON) -m venv build/engines
	for engine in drake mujoco pybullet; do \
		build/engines/bin/python $(PIP_INSTALL) --only-binary :all: $$engine || echo "$$engine cannot be installed here"; \
	done
	SDFCHECK_ENGINES=$(CURDIR)/build/engines/bin/python $(BIN)/python -m pytest -q -n0 -m peers \
		tests/unit/consumers/test_engines.py tests/peers/test_drake.py

# Asks the consumers that are installed; SDFCHECK_ENGINES names a Python with the others.
reactions: $(TOOLS)
	$(BIN)/python -m sdfcheck.lint.rulebook.reactions

golden: $(TOOLS)
	$(BIN)/python -m pytest -q -n0 tests/test_golden*.py tests/test_docs.py --golden

# Findings are kept in build/fuzz.
fuzz: $(TOOLS)
	$(BIN)/python -m tests.fuzz --minutes $(MINUTES) --seed $(SEED)
	$(BIN)/python -m tests.fuzz --kills 30 --seed $(SEED)

# Writes the table of docs/testing.md.
growth: $(TOOLS)
	$(BIN)/python -m benchmarks.growth --write

# Changes the code a little, many times, and lists the changes that no test notices.
mutants: $(TOOLS)
	$(BIN)/python -m tests.mutation --seed $(SEED)

# Measures an ordinary installation: an editable one starts slower.
bench: pyproject.toml setup.py
	[ -x $(BENCH_VENV)/bin/python ] || $(PYTHON) -m venv $(BENCH_VENV)
	rm -rf build/lib build/bdist.*
	$(BENCH_VENV)/bin/python $(PIP_INSTALL) .
	$(BENCH_VENV)/bin/python $(PIP_INSTALL) --force-reinstall --no-deps .
	$(BENCH_VENV)/bin/python -m benchmarks.run

docs: $(SITE_TOOLS)
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet

# Corrections of a release replace its pages: 0.1.0 and 0.1.1 are both 0.1.
publish-site: $(SITE_TOOLS)
	release=$$($(BIN)/python -c 'from sdfcheck.release import __version__; print(__version__.rpartition(".")[0])') && \
	export NO_MKDOCS_2_WARNING=1 PATH="$(abspath $(BIN)):$$PATH" && \
	mike --quiet deploy --update-aliases $(PUSH) "$$release" latest && \
	mike --quiet set-default $(PUSH) latest

versions: $(SITE_TOOLS)
	$(BIN)/python -m pytest -q -n0 tests/test_site.py

vscode: vscode-check
	cp docs/sdfcheck.schema.json LICENSE editors/vscode/
	cd editors/vscode && npm run --silent package

vscode-check:
	cd editors/vscode && npm install --no-audit --no-fund --silent && npm test --silent

package: $(RUNTIME)
	$(BIN)/python $(PIP_INSTALL) 'build>=1.2'
	rm -rf build/dist build/try build/lib build/bdist.*
	mkdir -p build
	$(BIN)/python -m build --outdir build/dist . >build/package.log 2>&1 || (cat build/package.log; exit 1)
	for kind in whl tar.gz; do \
	  $(PYTHON) -m venv --clear build/try && \
	  build/try/bin/python $(PIP_INSTALL) build/dist/sdfcheck-*.$$kind && \
	  build/try/bin/sdfcheck lint --isolated --quiet fixtures/robots/diff_drive && \
	  build/try/bin/sdfcheck rule JNT007 >/dev/null || exit 1; \
	done
	tar -tf build/dist/sdfcheck-*.tar.gz | grep -q /tests/test_rules.py
	tar -tf build/dist/sdfcheck-*.tar.gz | grep -q /docs/tutorial.md
	tar -tf build/dist/sdfcheck-*.tar.gz | grep -q /viewer/src/main.ts
	! grep -nE 'is absent from|Deprecat' build/package.log

man: $(RUNTIME)
	$(BIN)/python -m tables.man_page build/man/sdfcheck.1

release-check: package
	for minor in 10 11 12 13 14; do \
	  for python in python3.$$minor $(PYTHONS)/3.$$minor.*/bin/python3 ""; do \
	    $$python -c "" 2>/dev/null && break; \
	  done; \
	  [ -n "$$python" ] || { echo "Python 3.$$minor is not here: not tried"; continue; }; \
	  for kind in whl tar.gz; do \
	    $$python -m venv --clear build/try && \
	    build/try/bin/python $(PIP_INSTALL) build/dist/sdfcheck-*.$$kind && \
	    build/try/bin/sdfcheck lint --isolated --quiet fixtures/robots/diff_drive && \
	    build/try/bin/sdfcheck lint --isolated --quiet fixtures/robots/rover && \
	    build/try/bin/sdfcheck convert urdf-to-sdf --isolated --quiet fixtures/robots/desk_arm/desk_arm.urdf >/dev/null && \
	    build/try/bin/sdfcheck rule JNT007 >/dev/null || exit 1; \
	  done; \
	  echo "Python 3.$$minor: both distributions work"; \
	done

# The tests with the lowest versions that pyproject.toml promises, and with the newest that there are.
lowest: pyproject.toml
	$(PYTHON) -m venv --clear build/lowest
	$(PYTHON) -m tables.lowest >build/lowest/constraints.txt
	build/lowest/bin/python $(PIP_INSTALL) --constraint build/lowest/constraints.txt --editable '.[dev]'
	build/lowest/bin/python -m pytest

newest: pyproject.toml
	$(PYTHON) -m venv --clear build/newest
	build/newest/bin/python $(PIP_INSTALL) --editable '.[dev]'
	build/newest/bin/python -m pytest

picture: $(TOOLS)
	$(BIN)/python -m tables.picture
	$(BIN)/python -m tables.badges

viewer: viewer-check
	cd viewer && npm run --silent build

# Needs Chromium.
gallery: $(TOOLS)
	$(BIN)/python $(PIP_INSTALL) --editable '.[browser]'
	$(BIN)/python -m tests.peers.gallery

viewer-check:
	cd viewer && npm ci --no-audit --no-fund --silent && npm run --silent check

$(RUNTIME): pyproject.toml setup.py $(CONSTRAINTS)
	[ -x $(BIN)/python ] || $(PYTHON) -m venv $(VENV)
	$(BIN)/python $(PIP_INSTALL) --constraint $(CONSTRAINTS) --editable .
	touch $@

$(TOOLS): $(RUNTIME)
	$(BIN)/python $(PIP_INSTALL) --constraint $(CONSTRAINTS) --editable '.[dev]'
	touch $@

# The conditions of the rules in one module, so that a clean file loads no rule; not in the repository.
$(CONDITIONS): $(RUNTIME) $(RULES)
	$(BIN)/python -m sdfcheck.lint.rulebook.conditions
	touch $@

# With PYTHONDONTWRITEBYTECODE, as in many containers, each start of a checkout would compile all that it imports.
compiled: $(RUNTIME) $(CONDITIONS)
	$(BIN)/python -m compileall -q sdfcheck rules

$(SITE_TOOLS): $(RUNTIME)
	$(BIN)/python $(PIP_INSTALL) --editable '.[docs]'
	touch $@

# mypy finds the rules under the name that they are imported by.
build/mypy/sdfcheck_rules:
	mkdir -p $(@D)
	ln -sfn ../../rules $@

clean:
	rm -rf $(VENV) build .mypy_cache .pytest_cache .ruff_cache .hypothesis
