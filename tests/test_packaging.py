"""What `pip install` gets: the package with generated C and page parts, and not the data or the tests."""

import pathlib
import subprocess
import sys
import tarfile
import zipfile

import pytest

ROOT = pathlib.Path(__file__).parents[1]


@pytest.fixture
def built(tmp_path):
    """Build one target of this repository as `pip install` would; return the archive."""

    def build(target):
        command = [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(tmp_path)]
        subprocess.run(command, check=True, cwd=ROOT, capture_output=True)
        (archive,) = tmp_path.iterdir()
        return archive

    return build


@pytest.mark.slow
def test_the_wheel_carries_the_generated_c_and_nothing_but_the_package(built):
    names = zipfile.ZipFile(built("wheel")).namelist()
    source = ROOT / "src" / "similitude" / "generated"
    generated = {f"similitude/generated/{path.name}" for path in source.glob("*.c")}

    assert generated and generated <= set(names)
    assert {name.split("/")[0].split("-")[0] for name in names} == {"similitude"}
    assert any(name.endswith("licenses/LICENSE") for name in names)


@pytest.mark.slow
def test_the_wheel_carries_what_an_html_page_is_made_of(built):
    names = set(zipfile.ZipFile(built("wheel")).namelist())
    source = ROOT / "src"
    report = source / "similitude" / "report"
    wanted = [*report.glob("html_page.*"), *(report / "vendor" / "uplot").iterdir()]

    assert {"html_page.css", "html_page.js", "LICENSE", "uPlot.iife.min.js"} <= {p.name for p in wanted}
    assert {path.relative_to(source).as_posix() for path in wanted} <= names


@pytest.mark.slow
def test_the_source_distribution_leaves_data_and_tests_at_home(built):
    names = tarfile.open(built("sdist")).getnames()
    tops = {name.split("/")[1] for name in names if "/" in name}
    wanted = {"src", "README.md", "LICENSE", "CHANGELOG.md", "PKG-INFO", "pyproject.toml"}

    assert wanted <= tops <= wanted | {".gitignore"}
