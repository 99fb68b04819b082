"""An entrant's file: read, named after itself, and refused with all four parts."""

import pytest

from similitude.benchmark.entrant import Answer, read_entrant
from similitude.errors import UsageError

from .linear_drive import linear_drive

GOOD = '''"""Always the average car.

More words.
"""
from similitude.benchmark.entrant import Answer


def estimate(drive):
    return Answer(K=145.7, ln_K_std=0.5)
'''


def test_an_entrant_is_named_after_its_file(tmp_path):
    path = tmp_path / "average.py"
    path.write_text(GOOD)
    one = read_entrant(path)

    assert (one.name, one.about, one.whole_log) == ("average", "Always the average car.", False)
    assert isinstance(one.estimate(linear_drive()[0]), Answer)


@pytest.mark.parametrize(
    "text", ["def guess(drive): pass", "estimate = 3", "import no_such_thing", "def estimate(", "1/0"]
)
def test_a_file_that_is_no_entrant_is_refused_by_name(tmp_path, text):
    path = tmp_path / "mine.py"
    path.write_text(text)
    with pytest.raises(UsageError) as refused:
        read_entrant(path)

    assert "mine.py" in refused.value.what
    assert all((refused.value.usually, refused.value.paste, refused.value.read))


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(UsageError, match=r"none\.py"):
        read_entrant(tmp_path / "none.py")
