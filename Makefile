# Each target is enough by itself on a fresh clone: it makes .venv, installs, and runs.
PYTHON ?= python3
BIN := .venv/bin
DEV := .venv/.installed-dev
BENCH := .venv/.installed-bench
FUZZ := .venv/.installed-fuzz
# Shared out as tests/conftest.py has it.
TESTS := $(BIN)/python -m pytest -q -n auto
# Processor time shared by the readers that are fuzzed; by hand, a day: make fuzz FUZZ_SECONDS=86400
FUZZ_SECONDS ?= 600

.PHONY: demo test check lint all fuzz bench accuracy accelerometer multi-body foreign-truth alarms spacing ladder cross-check real-logs damage embedded populations gallery clean

demo: $(DEV)
	$(BIN)/python scripts/demo.py

test: $(DEV)
	$(TESTS)

check: lint
	$(TESTS) -m slow

lint: $(DEV)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

# `make check test` with what both need made once.
all: lint
	$(TESTS) -m ""

fuzz: $(FUZZ)
	$(BIN)/python -m fuzz --seconds $(FUZZ_SECONDS)

bench: $(BENCH)
	$(BIN)/python -m bench

multi-body: $(DEV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[dev,plants]"
	$(BIN)/python scripts/multi_body.py

foreign-truth: $(DEV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e ".[dev,plants]"
	$(BIN)/python scripts/foreign_truth.py

alarms: $(DEV)
	$(BIN)/python scripts/alarms.py

accuracy: $(DEV)
	$(BIN)/python scripts/accuracy.py

accelerometer: $(DEV)
	$(BIN)/python scripts/accelerometer.py

spacing: $(DEV)
	$(BIN)/python scripts/spacing.py

ladder: $(DEV)
	$(BIN)/python scripts/ladder.py

cross-check: $(DEV)
	$(BIN)/python scripts/cross_check.py

real-logs: $(DEV)
	$(BIN)/python scripts/real_logs.py

damage: $(DEV)
	$(BIN)/python scripts/damage.py

# Installs no tool; those of docs/embedded.md, "Targets", that are here are used, the others are named.
embedded: $(DEV)
	$(BIN)/python scripts/embedded.py
	$(BIN)/python scripts/embedded_static.py
	$(BIN)/python scripts/embedded_decisions.py

populations: $(DEV)
	$(BIN)/python scripts/build_populations.py
	$(BIN)/python scripts/populations.py

gallery: $(DEV)
	$(BIN)/python scripts/gallery.py
	$(BIN)/python scripts/reduced_car.py

$(FUZZ): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev,fuzz]'
	@touch $@

clean:
	rm -rf .venv demo-out similitude-out fuzz-failures build dist

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "similitude needs Python 3.11 or newer; name one with: make PYTHON=python3.12 <target>"; exit 1; }
	@$(PYTHON) -m venv .venv || \
	  { rm -rf .venv; echo "$(PYTHON) has no venv module; on Debian and Ubuntu: apt install python3-venv"; exit 1; }

$(DEV): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	@touch $@

$(BENCH): pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev,bench]'
	@touch $@
