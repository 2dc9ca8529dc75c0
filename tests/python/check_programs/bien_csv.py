"""A right program: comma-separated, every digit of the doubles, names in English."""

from pendulum import problems

for k, rows in problems():
    print(",".join(["time", "theta", "omega", "sine"][: 4 if k == -1 else 3]))
    for row in rows:
        print(",".join(map(repr, row)))
