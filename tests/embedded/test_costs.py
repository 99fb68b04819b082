"""Cost is measured or absent, never guessed."""

import json
from pathlib import Path

from similitude.embedded.costs import Cost, costs_of, missing_tools
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.targets import TARGETS

BUDGETS = Path(__file__).parents[2] / "scripts" / "embedded_budgets.json"


def test_without_tools_there_is_no_cost(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", "/nowhere")

    assert missing_tools(TARGETS["cortex-m4f"]) == ("arm-none-eabi-gcc", "qemu-system-arm")
    assert missing_tools(TARGETS["host"]) == ()
    assert costs_of(tmp_path, find_source("bicycle", "paper"), "float", TARGETS["cortex-m0"], None) is None


def test_flash_is_step_init_and_configuration():
    figures = dict.fromkeys(Cost.__dataclass_fields__, 1)
    cost = Cost(**{**figures, "step": 100, "init": 10, "numbers": 5, "saving": 1000})

    assert cost.flash == 115 and cost.record["flash"] == 115


def test_every_estimator_has_a_budget_on_the_m4f():
    budgets = json.loads(BUDGETS.read_text())

    for system, estimators in SHIPPED.items():
        for estimator in estimators:
            assert set(budgets[f"{system}_{estimator}/cortex-m4f"]) == {"most", "flash", "state", "stack"}
