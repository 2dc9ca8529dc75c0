"""The console scripts, outside of the package pendula, so that Ctrl-C ends them quietly also while that is imported."""

import os
import signal

INTERRUPTED = 130  # as pendula says it, which is not yet there


def check() -> int:
    """`pendula check`."""
    before = _end_at_ctrl_c()
    from pendula.check._main import main

    signal.signal(signal.SIGINT, before)
    return main()


def plot() -> int:
    """`pendula plot`."""
    before = _end_at_ctrl_c()
    from pendula.plot._main import main

    signal.signal(signal.SIGINT, before)
    return main()


def _end_at_ctrl_c() -> "signal._HANDLER":
    """Nothing is under way that must be left in order. A script that was started to ignore Ctrl-C goes on ignoring it."""
    before = signal.getsignal(signal.SIGINT)
    if before is signal.default_int_handler:
        signal.signal(signal.SIGINT, lambda *_: os._exit(INTERRUPTED))
    return before
