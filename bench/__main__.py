"""Entry of `make bench`: prints what is measured; every figure is a ratio inside one run."""

import sys


def main() -> int:
    """Run every measurement; none is defined yet."""
    print("no measurement is defined yet")
    return 0


if __name__ == "__main__":
    sys.exit(main())
