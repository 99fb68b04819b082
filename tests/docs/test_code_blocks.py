"""What the pages show can be pasted: code runs, named files exist, "read more" leads somewhere."""

import ast
import os
import pathlib
import re
import shlex
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
FENCE = re.compile(r"^```(\w+)[^\n]*\n(.*?)^```", re.DOTALL | re.MULTILINE)
SEE = re.compile(r"(docs/[\w/.-]+\.md|README\.md)(?:, [\"“]([^\"”]+)[\"”])?")


def blocks(pages, *languages):
    """Every fenced block in one of the languages, named after its page and line."""
    for page in pages:
        text = page.read_text(encoding="utf-8")
        for found in FENCE.finditer(text):
            line = text[: found.start()].count("\n") + 1
            if found.group(1) in languages:
                yield pytest.param(found.group(2), id=f"{page.name}:{line}")


def commands(block: str) -> list[list[str]]:
    """The commands of a console block; where there are prompts, other lines are output."""
    lines = block.replace("\\\n", " ").splitlines()
    if any(line.startswith("$ ") for line in lines):
        lines = [line[2:] for line in lines if line.startswith("$ ")]
    words = [shlex.split(line, comments=True) for line in lines]
    return [command for command in words if command[:1] == ["similitude"]]


@pytest.fixture
def paste(tmp_path):
    """Run a command as someone would who stands in a clone; nothing is written into this one."""
    (tmp_path / "data").symlink_to(ROOT / "data")
    path = os.pathsep.join((str(pathlib.Path(sys.executable).parent), os.environ["PATH"]))

    def run(command):
        done = subprocess.run(
            command,
            cwd=tmp_path,
            env={**os.environ, "PATH": path},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, f"{shlex.join(command)}\n{done.stdout}{done.stderr}"

    return run


@pytest.mark.parametrize("block", list(blocks(PAGES, "python")))
def test_a_python_block_runs_by_itself(paste, block):
    paste([sys.executable, "-c", block])


@pytest.mark.parametrize("block", list(blocks(PAGES, "console", "bash")))
def test_the_commands_of_a_block_run(paste, block):
    for command in commands(block):
        paste(command)


def test_the_readme_shows_code_and_commands():
    readme = [ROOT / "README.md"]
    shown = [commands(block.values[0]) for block in blocks(readme, "console", "bash")]

    assert any(shown) and list(blocks(readme, "python"))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_a_page_names_exist(page):
    named = re.findall(r"`((?:data|docs|src|tests|scripts)/[\w./-]*)`", page.read_text())

    assert [name for name in named if not (ROOT / name).exists()] == []


def test_read_more_leads_to_a_page_and_a_heading_that_exist():
    lost = []
    for source in sorted((ROOT / "src").rglob("*.py")):
        for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                lost += [f"{source.name}:{node.lineno} {what}" for what in _lost(node.value)]

    assert sorted(set(lost)) == []


def _lost(text: str) -> list[str]:
    missing = []
    for page, heading in SEE.findall(text):
        if not (ROOT / page).exists():
            missing.append(page)
        elif heading and not re.search(
            rf"^#+ {re.escape(heading)}\s*$", (ROOT / page).read_text(), re.MULTILINE
        ):
            missing.append(f'{page}, "{heading}"')
    return missing
