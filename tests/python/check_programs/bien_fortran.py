"""A right program in the manner of Fortran: exponents with a D, columns right-adjusted, a blank line after each row."""

from pendulum import problems

for _, rows in problems():
    print("#        t           theta          theta_punto     theta_seno")
    for row in rows:
        print("".join(f"{value:16.8E}".replace("E", "D") for value in row), end="\n\n")
