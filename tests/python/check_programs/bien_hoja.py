"""A right spreadsheet: semicolons, decimal commas, five decimals, accents in Latin-1, an energy beside, Windows' line ends."""

import math
import sys

from pendulum import problems

lines = []
for k, rows in problems():
    seno = ["Función sinusoidal (rad)"] if k == -1 else []
    lines.append(";".join(["Tiempo (s)", "Ángulo (rad)", "Velocidad angular (rad/s)", *seno, "Energía"]))
    for row in rows:
        energy = row[2] ** 2 / 2 + 1 - math.cos(row[1])
        lines.append(";".join(f"{value:.5f}" for value in [*row, energy]).replace(".", ","))
    lines.append("")
sys.stdout.buffer.write("\r\n".join(lines).encode("latin-1"))
