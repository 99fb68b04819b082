# Each target is enough by itself on a fresh clone: it makes .venv, installs, and runs.
PYTHON ?= python3
BIN := .venv/bin
DEV := .venv/.installed-dev
BENCH := .venv/.installed-bench

.PHONY: demo test check bench accuracy spacing clean

demo: $(DEV)
	$(BIN)/python scripts/demo.py

test: $(DEV)
	$(BIN)/python -m pytest -q -n auto

check: $(DEV)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python -m pytest -q -n auto -m slow

bench: $(BENCH)
	$(BIN)/python -m bench

accuracy: $(DEV)
	$(BIN)/python scripts/accuracy.py

spacing: $(DEV)
	$(BIN)/python scripts/spacing.py

clean:
	rm -rf .venv demo-out similitude-out build dist

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
