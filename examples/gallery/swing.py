"""A pendulum that all but stands on its head, beside its phase plane: swing.py DIRECTORY."""

import sys
from pathlib import Path

import pendula

tau = pendula.analyze(3.0, 0.0).tau
swing = pendula.solve(3.0, 0.0, every=tau / 100, until=tau * 0.99)
pendula.plot.animate(swing, speed=2).save(Path(sys.argv[1], "swing.gif"), writer="pillow", dpi=60)
