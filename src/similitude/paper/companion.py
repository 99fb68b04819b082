"""The page: ours beside theirs, for an engineer who reads the paper.

Invariant: every number on the page is taken from a claim, an equation or a figure; none is typed here.
"""

from __future__ import annotations

import re
from typing import Any

from similitude.paper.claim import CONDITION, FAILS, HOLDS, NOTHING, Claim
from similitude.paper.claims_cost import counted
from similitude.paper.claims_figure_5 import (
    FITTING,
    HOLD,
    filter_reads,
    least_sd,
    paper_tracking,
    perfect_tracking,
    tracking,
)
from similitude.paper.claims_figure_7 import DRY, PLANING, RETURN, belt_filter, coverage, excursions, gains
from similitude.paper.drives import SOFT, SOFTEST
from similitude.paper.errata import ERRATA
from similitude.paper.pictures import PICTURES
from similitude.paper.reproduction import Reproduction
from similitude.report.html_page import (
    Html,
    badge,
    bullets,
    details,
    joined,
    lead,
    markup,
    page,
    paragraph,
    picture,
    section,
    strong,
    table,
)

TITLE = "Sensitivity invariance and the stiffness of tyres: the paper, reproduced"
TONES = {HOLDS: "good", CONDITION: "fair", FAILS: "poor"}
SOURCE = (
    "S. Brennan, A. Alleyne: Real-time identification of vehicle chassis dynamics using a novel "
    "reparameterization based on sensitivity invariance. International Journal of Adaptive Control and "
    "Signal "
    "Processing 18 (2004)."
)


def companion(done: Reproduction) -> str:
    """Compose the page.

    Parameters
    ----------
    done : Reproduction   with its pictures.

    Returns
    -------
    str   an HTML document that needs no other file
    """
    claims = {claim.id: claim for claim in done.claims}
    parts = [
        _lead(done),
        _idea(),
        _figures(done, "Figures 1 to 4: the vehicle and its groups", ("1", "2", "3", "4")),
        _figures(done, "Figures 5 to 7: the drives", ("5", "6", "7")),
        _errata(claims),
        *(_subject(name, found) for name, found in done.subjects.items()),
        _figures(done, "What stands against the method", ("noise", "seven")),
        _today(done),
        _equations(done),
        _how(),
    ]
    return page(TITLE, parts, {})


def _lead(done: Reproduction) -> Html:
    count = done.count()
    told = [badge(f"{n} {word}", TONES[word]) for word, n in count.items()]
    return lead(
        paragraph(*[joined([one, " "]) for one in told], strong(f"{sum(count.values())} claims")),
        paragraph(SOURCE),
        paragraph(
            "Every figure, equation and checkable statement of the paper beside what this package "
            "computes. The idea "
            "holds: units tie sensitivities together, groups untie them, and what is left to identify is "
            "one stiffness. "
            "The estimator that the paper builds on it does not survive a real gyro; what the idea "
            "becomes with a "
            "population as prior stands at the end."
        ),
    )


def _idea() -> Html:
    return section(
        "The idea in five lines",
        bullets(
            [
                "A law of physics stays true in other units. By Euler's theorem the logarithmic "
                "sensitivities of any "
                "output then obey one linear equation a unit: they are coupled (eqs 5 to 16).",
                "Written in Pi groups these equations are empty: mass, length and speed leave the model, "
                "four groups "
                "remain (eqs 17 and 19).",
                "Vehicles are built for one purpose and cluster in group space: all groups but π3 may be "
                "taken from a "
                "population (eq 18).",
                "With them frozen the z-transform is nearly linear in π3, and recursive least squares "
                "finds it (eqs 20 "
                "to 28).",
                "A regulator drives the test vehicle meanwhile (eqs 29 to 32).",
            ]
        ),
    )


def _figures(done: Reproduction, title: str, names: tuple[str, ...]) -> Html:
    shown = []
    for name in names:
        one = PICTURES[name]
        notes = [f"The paper: {one.theirs}", f"Ours: {one.ours}"] if one.theirs else [one.ours]
        shown.append(picture(done.pictures[one.file], one.title, *notes))
    return section(title, *shown)


def _errata(claims: dict[str, Claim]) -> Html:
    rows = []
    for erratum in ERRATA:
        found = claims[erratum.claim]
        check = f"{erratum.claim}: printed {shown(found.printed)}, ours {shown(found.ours)}"
        rows.append((erratum.where, erratum.as_printed, erratum.holds, check))
    note = "Each with the claim whose computation shows it; the claims follow."
    return section("Errata", table(["where", "printed", "holds", "check"], rows), paragraph(note, quiet=True))


def _subject(name: str, claims: list[Claim]) -> Html:
    rows = [
        (
            joined([claim.id, _quiet(claim.where)]),
            claim.statement,
            _with_unit(claim.printed, claim.unit),
            _with_unit(claim.ours, claim.unit),
            joined([badge(claim.verdict, TONES[claim.verdict]), _reason(claim)]),
        )
        for claim in claims
    ]
    return section(name, table(["claim", "the paper says", "printed", "ours", "verdict"], rows))


def _reason(claim: Claim) -> Html:
    when = f"Where {claim.condition}. " if claim.condition else ""
    told = f"{when}{claim.why} Tolerance: {shown(claim.tolerance)}.".replace("  ", " ")
    return paragraph(re.sub(r"(?<![\w)])-(?=\d)", "−", told), quiet=True)


def _quiet(text: str) -> Html:
    return paragraph(text, quiet=True)


def _today(done: Reproduction) -> Html:
    n, found, sd = counted(), tracking(*filter_reads()), least_sd()
    perfect, noisy = paper_tracking(), paper_tracking(perfect=False)
    fitting = paper_tracking(forgetting=FITTING)
    rows = [
        ("what is frozen", "four groups at averages", "nothing: they are a prior"),
        ("operations a sample", f"{n['paper']}", f"{n['filter']}"),
        (
            "Figure 5, rms of ln K, perfect sensor",
            f"{perfect['rms']:.2f}; {fitting['rms']:.3f} with λ = {FITTING}",
            f"{perfect_tracking()['rms']:.3f}",
        ),
        ("Figure 5, rms of ln K, gyro 0.1 deg/s", f"{noisy['rms']:.1f}", f"{found['rms']:.3f}"),
        ("least sd at the end of Figure 5 (bound)", "", f"{sd[-1]:.4f}"),
        (
            "half-way to a new stiffness, median of five",
            f"{_delay(perfect)}, perfect sensor; {_delay(fitting)} with λ = {FITTING}",
            _delay(found),
        ),
        (
            "Figure 5, 95 % interval holds the truth",
            "states none",
            f"{100 * found['coverage']:.0f} % of the time",
        ),
        (
            "Figure 7, the same on the dry, uneven belt",
            "states none",
            f"{100 * coverage(*belt_filter()):.0f} % of 20 to 60 s",
        ),
    ]
    shown = [
        picture(done.pictures[PICTURES[k].file], PICTURES[k].title, PICTURES[k].ours)
        for k in ("today-5", "today-7")
    ]
    told = paragraph(
        "Freezing a group is the limit of a prior without width. Keep the width, and a Kalman filter on "
        "the same dimensionless model says what it knows and what it does not. It reads the gyro that the "
        "regression cannot read, and the gain of the regulator can follow it while it drives. On the uneven "
        "belt of Figure 7 its interval is too narrow."
    )
    return section(
        "What the paper's idea becomes today",
        told,
        table(["", "the paper's", "population filter"], rows),
        *shown,
        _gains(),
    )


def _delay(tracked: dict[str, float]) -> str:
    """The median delay to half-way in words, where it may be longer than a stretch."""
    delay = tracked["half_way"]
    return f"{delay:.2f} s" if delay < HOLD else f"longer than the {HOLD:.0f} s between two changes"


GAINS = {
    "fixed": "the paper's, for the dry stiffness",
    "soft": f"one gain, for {SOFT} of it",
    "softest": f"one gain, for {SOFTEST} of it, as is left while hydroplaning",
    "estimate": "follows the population filter",
    "truth": "follows the true stiffness",
}


def _gains() -> Html:
    """Figure 7 by the regulator's gain: what following the estimate buys, and over what."""
    windows = {name: [excursions(d, *w) for w in (DRY, PLANING, RETURN)] for name, d in gains().items()}
    rows = [
        (
            GAINS[name],
            *(f"{100 * there['rms']:.1f} cm" for there in (dry, wet)),
            *(f"{there['beta']:.2f} rad" for there in (wet, back)),
            f"{wet['r']:.2f} rad/s",
        )
        for name, (dry, wet, back) in windows.items()
    ]
    over = {n: [windows["estimate"][i]["rms"] / windows[n][i]["rms"] - 1 for i in (0, 1)] for n in windows}
    against = [
        f"{GAINS[n]}: {_percent(over[n][0])} on the dry, {_percent(over[n][1])} hydroplaning"
        for n in ("fixed", "soft", "softest")
    ]
    note = (
        f"Distance with the gain that follows the filter, against {'; '.join(against)}. A soft gain must be "
        "chosen beforehand. See the claims today-scheduled and today-soft-gain."
    )
    heads = ["Figure 7, gain", "rms on the dry", "rms hydroplaning", "sideslip there", "on the way back"]
    return joined([table([*heads, "yaw rate hydroplaning"], rows), paragraph(note, quiet=True)])


def _percent(change: float) -> str:
    return f"{100 * change:+.0f} %".replace("-", "−")


def _equations(done: Reproduction) -> Html:
    rows = [
        (
            f"eq {equation.number}",
            equation.says,
            equation.code,
            "exact" if residual <= NOTHING else f"within {shown(equation.tolerance)}",
        )
        for equation, residual in done.residuals
    ]
    note = (
        "Each is checked by running the code that is named. Where the print cannot hold (see the errata) it "
        "is the corrected form that is implemented and checked."
    )
    listed = details("Equations 1 to 32", table(["", "says", "implemented by", "holds"], rows))
    return section("Every equation as code", paragraph(note), listed)


def _how() -> Html:
    return section(
        "How this page was made",
        paragraph(
            "similitude paper computes it from the package alone, with fixed seeds: the drives from "
            "the shipped "
            "scenarios square_closed_loop, treadmill_hydroplaning, wet_lane, peak_only and "
            "friction_step "
            "(similitude simulate --list), the estimators from the generated C. claims.json holds "
            "the same "
            "claims for programs."
        ),
    )


def _with_unit(value: Any, unit: str) -> str:
    return shown(value) if unit == "-" or isinstance(value, str) else f"{shown(value)} {unit}"


def shown(value: Any) -> str:
    """A printed or computed value as text: numbers with a true minus, lists one after the other."""
    if isinstance(value, list | tuple):
        return ", ".join(shown(each) for each in value)
    if isinstance(value, str):
        return value
    if isinstance(value, float) and value != 0 and not 1e-4 <= abs(value) < 1e6:
        mantissa, _, power = f"{value:.3g}".partition("e")
        digits = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        return f"{mantissa} × 10{digits}" if mantissa != "1" else f"10{digits}"
    return str(markup(f"{value:.10g}".replace("-", "−")))
