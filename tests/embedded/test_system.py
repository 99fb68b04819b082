"""A shipped system, or a file of the user's: found, or told why not."""

import pytest

from similitude.embedded.system import find_source
from similitude.errors import ModelError, UsageError


@pytest.mark.parametrize(
    ("system", "estimator", "said"),
    [
        ("bicycle", "kalman", "is not exported"),
        ("tricycle", "paper", "no shipped system"),
        ("saturating_bicycle", "paper", "ships no estimator"),
        ("nowhere.py", "paper", "there is no file"),
    ],
)
def test_what_does_not_exist_is_named(system, estimator, said):
    with pytest.raises(UsageError, match=said):
        find_source(system, estimator)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("x = 1\n", "should hold one Reduction, and there is none"),
        ("1 / 0\n", "does not run: ZeroDivisionError"),
        (
            "from similitude.systems.bicycle import bicycle_reduction as a\none, two = a(), a()\n",
            "2 of them: one, two",
        ),
        (
            "from similitude.systems.bicycle import bicycle_reduction as a\none = a()\nCONFIG = [1]\n",
            "not a mapping",
        ),
    ],
)
def test_a_file_without_one_reduction_says_so(tmp_path, text, said):
    path = tmp_path / "mine.py"
    path.write_text(text)
    with pytest.raises(ModelError, match=said):
        find_source(str(path), "band")
