"""Logs for tests: a plausible drive, and its CSV with one thing changed."""

import numpy as np

HEADERS = ("t [s]", "delta [rad]", "r [rad/s]", "U [m/s]")


def drive(samples=300, rate=100.0):
    """Columns (n, 4) of `HEADERS`: a car of wheelbase 2.7 m, weaving at 20 m/s."""
    t = np.arange(samples) / rate
    delta = 0.02 * np.sin(2 * np.pi * 0.5 * t)
    speed = 20 + 0.5 * np.sin(0.3 * t)
    return np.column_stack([t, delta, 0.6 * speed * delta / 2.7, speed])


def csv_text(columns, *, headers=HEADERS, separator=",", decimal=".", end="\n"):
    """The CSV of columns (n, k); 17 digits, so that reading gives back the same floats."""
    rows = [separator.join(f"{x:.17g}".replace(".", decimal) for x in row) for row in columns]
    return end.join([separator.join(headers), *rows]) + end


def write(folder, text, name="drive.csv"):
    """Write text or bytes to a file of the folder and return its path."""
    path = folder / name
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path
