"""How the tests are shared out: a folder stays in one process, and the longest begin first.

What a folder derives, drives or fits once then serves all of its tests, and no long test begun last leaves
processors idle. Files of no folder are shared out one by one.
"""

import os
from collections import Counter

import pytest

# Before NumPy: each process has a processor to itself, and small matrices wait for threads that have none.
os.environ.setdefault("OMP_NUM_THREADS", "1")


def together(nodeid):
    """What a test shares its process with: tests/<folder> or tests/<file>."""
    return "/".join(nodeid.partition("::")[0].split("/")[:2])


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """In place of every ``--dist``; the order is that of the collection."""
    from xdist.scheduler import LoadScopeScheduling

    class ByFolder(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return together(nodeid)

    config.option.loadscopereorder = False
    return ByFolder(config, log)


def pytest_collection_modifyitems(items):
    """Those with most long tests first, then those with most tests."""
    sizes = Counter(together(item.nodeid) for item in items)
    long = Counter(together(item.nodeid) for item in items if item.get_closest_marker("slow"))
    items.sort(key=lambda item: (-long[together(item.nodeid)], -sizes[together(item.nodeid)]))
