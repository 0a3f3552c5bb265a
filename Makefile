# Each target sets up what it needs in .venv; Python 3.11+ and make are assumed.
# PYTHON chooses the interpreter of a new .venv, ARGS is handed to the command of the target.

PYTHON ?= python3
ARGS ?=
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: help paper test test-slow test-all generate check lint docs attack bench exactness pictures validate clean

help:
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | expand -t 12

paper: $(VENV)/with-plot ## the article's figures and table, into paper-figures/
	$(BIN)/hoopgen paper --out paper-figures $(ARGS)

# SymPy remembers a thousand results a function unless told: too few for a scene.
export SYMPY_CACHE_SIZE ?= 20000

# Byte code is kept whatever the environment says: hundreds of tests start Python.
test test-slow test-all: export PYTHONDONTWRITEBYTECODE :=

test: $(VENV)/with-dev ## most tests and a sample of the slow ones, in five minutes on two cores
	HOOPGEN_TEST_EFFORT=$${HOOPGEN_TEST_EFFORT:-0.2} $(BIN)/python -m pytest -n auto --dist loadgroup -m "not slow" $(ARGS)

test-slow: $(VENV)/with-dev ## what make test leaves out: slow tests, and random ones at full effort
	$(BIN)/python -m pytest -n auto --dist loadgroup -m "slow or scaled" $(ARGS)

test-all: $(VENV)/with-dev ## every test once, at full effort
	$(BIN)/python -m pytest -n auto --dist loadgroup $(ARGS)

generate: $(VENV)/with-compile ## write generated/ from derive/ and templates/
	$(BIN)/hoopgen generate $(ARGS)

check: $(VENV)/with-generate ## fail if generated/ is not what derive/ and templates/ give
	$(BIN)/hoopgen check $(ARGS)

lint: $(VENV)/with-dev $(VENV)/typing ## format, lint and types
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy

docs: $(VENV)/with-docs $(if $(shell command -v cc),,$(VENV)/with-compile) ## the site, into docs/_build/html; every example of it is run
	$(BIN)/sphinx-build -E -W --keep-going -j auto -b html -d docs/_build/doctrees docs docs/_build/html $(ARGS)
	@! grep -rlE '<(script|link|img)[^>]*(src|href)="https?://' docs/_build/html --include='*.html' || \
	    { echo "these pages load something from a network"; exit 1; }
	@echo docs/_build/html/index.html

attack: $(VENV)/with-dev ## what should not be able to break it, tried; ARGS="--minutes 5 --seed 1"
	$(BIN)/python -m benchmarks.attack $(ARGS)

bench: $(VENV)/with-bench ## speed, beside the other methods or, ARGS="--base REF", a commit
	$(BIN)/python -m benchmarks $(ARGS)

exactness: $(VENV)/with-certify $(VENV)/with-generate ## results against ball arithmetic
	$(BIN)/python -m benchmarks.exactness $(ARGS)
	$(BIN)/python -m benchmarks.own_scenes

pictures: $(VENV)/with-study $(VENV)/with-generate ## docs' pictures
	$(BIN)/python -m benchmarks.pictures $(ARGS)

validate: $(VENV)/with-study $(VENV)/with-certify ## results beside those of the literature
	$(BIN)/python -m benchmarks.validation $(ARGS)

clean: ## remove all that these targets made, .venv too
	rm -rf $(VENV) build dist hoopgen/shipped hoopgen.egg-info paper-figures attack-findings
	rm -rf docs/_build docs/gallery docs/notebooks
	rm -rf .bench .hypothesis .mypy_cache .pytest_cache .ruff_cache
	rm -f hoopgen/engine/_*.so hoopgen/engine/_*.pyd
	find benchmarks derive generated hoopgen templates tests -name __pycache__ -prune -exec rm -rf {} +

$(BIN)/python:
	@echo "Making a virtual environment in $(VENV)"
	$(PYTHON) -m venv $(VENV)

# The C library is compiled at installation, so a change of its sources installs again.
$(VENV)/installed: pyproject.toml setup.py $(wildcard generated/c/*.[ch]) | $(BIN)/python
	@echo "Installing hoopgen and compiling its C engines: 40 s of CPU time, or for all widths two minutes, once"
	$(PIP) install --editable .
	@touch $@

# Tests compare all widths that the processor has; a new installation compiles them at once.
$(VENV)/with-dev: export HOOPGEN_WIDTHS := all
$(VENV)/with-dev: $(VENV)/installed
	@echo "Installing what 'dev' needs, and the C engines for all widths where they are not yet: two minutes, once"
	$(PIP) install 'hoopgen[dev]'
	$(BIN)/python setup.py -q build_ext --inplace
	@touch $@

# hoopgen is there already, so this adds only what the extra asks for.
$(VENV)/with-%: $(VENV)/installed
	@echo "Installing what '$*' needs"
	$(PIP) install 'hoopgen[$*]'
	@touch $@

# The installed names over the sources, for mypy (see pyproject.toml).
$(VENV)/typing: | $(BIN)/python
	mkdir -p $@.new/hoopgen
	ln -s ../../../derive ../../../generated ../../../templates $@.new/hoopgen
	mv $@.new $@
