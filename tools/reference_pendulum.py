"""The frictionless pendulum in ball arithmetic (Arb): the reference solution for tests/data/closed_form.txt.

The arguments are doubles and are taken as exact. Jacobi's elliptic functions are computed from theta functions, as in
DLMF 22.2. K and K' are computed from the complementary modulus k' and from k by the arithmetic-geometric mean. Both moduli
are computed directly, and neither from the other.
"""

import math
from dataclasses import dataclass

from flint import acb, arb, ctx

ctx.prec = 512

OSCILLATION, SEPARATRIX, ROTATION = -1, 0, 1


@dataclass
class Motion:
    regime: int
    theta_max: arb
    tau: arb
    nearness: float  # |alpha kappa'|, divided by its change for one ulp of theta, omega and alpha


def atan2(y: arb, x: arb) -> arb:
    return arb.atan2(y, x)


def floor(x: arb) -> int:
    """The floor of the midpoint. If the ball of x contains an integer, either number of turns is correct."""
    return int(x.mid().floor().unique_fmpz())


def wrap(theta: arb) -> tuple[arb, int]:
    turns = floor((theta + arb.pi()) / (2 * arb.pi()))
    return theta - 2 * arb.pi() * turns, turns


def complement(alpha: float, theta: float, omega: float) -> arb:
    """alpha cos^2(theta/2) - omega^2/4."""
    return arb(alpha) * (arb(theta) / 2).cos() ** 2 - arb(omega) ** 2 / 4


def movable(alpha: float, theta: float, omega: float) -> arb:
    """The change of the complement for one ulp of theta, omega and alpha, to first and second order."""
    a, th, w = arb(alpha), arb(theta), arb(omega)
    d_theta, d_omega, d_alpha = (arb(math.ulp(x)) for x in (theta, omega, alpha))
    return (
        a * abs(th.sin()) * d_theta / 2
        + a * d_theta**2 / 4
        + abs(w) * d_omega / 2
        + d_omega**2 / 4
        + (th / 2).cos() ** 2 * d_alpha
    )


def energy_ratio(alpha: float, theta: float, omega: float) -> arb:
    return (arb(theta) / 2).sin() ** 2 + arb(omega) ** 2 / (4 * arb(alpha))


def motion(alpha: float, theta: float, omega: float) -> Motion:
    h = complement(alpha, theta, omega)
    nearness = float(abs(h) / movable(alpha, theta, omega))
    a, pi = arb(alpha), arb.pi()
    kappa, kappa1 = energy_ratio(alpha, theta, omega), h / a
    if nearness <= 1:
        return Motion(SEPARATRIX, pi if omega >= 0 else -pi, time_to_top(alpha, theta, omega), nearness)
    if h > 0:
        theta_max = 2 * atan2(kappa.sqrt(), kappa1.sqrt())
        return Motion(OSCILLATION, theta_max, 2 * pi / (a.sqrt() * arb(1).agm(kappa1.sqrt())), nearness)
    return Motion(ROTATION, pi, pi / (a.sqrt() * kappa.sqrt().agm((-kappa1).sqrt())), nearness)


def time_to_top(alpha: float, theta: float, omega: float) -> arb:
    """The time (3.5), or 10/sqrt(alpha) at rest at the top or beyond 0.999 theta_max."""
    limit = arb(999) / 1000 * arb.pi()
    start = wrap(arb(theta))[0] * (1 if omega >= 0 else -1)
    if omega == 0 or start >= limit:
        return 10 / arb(alpha).sqrt()
    return ((limit / 2).tan().asinh() - (start / 2).tan().asinh()) / arb(alpha).sqrt()


class Solution:
    """The motion: theta in [-pi, pi), omega and whole turns at any time."""

    def __init__(self, alpha: float, theta: float, omega: float):
        self.alpha, self.theta, self.omega = alpha, theta, omega
        self.motion = motion(alpha, theta, omega)
        self.start, self.turns = wrap(arb(theta))
        self.rests = omega == 0 and (theta == 0 or self.motion.regime == SEPARATRIX)
        if self.motion.regime != SEPARATRIX and not self.rests:
            self._prepare()

    def _prepare(self):
        a, w = arb(self.alpha), arb(self.omega)
        kappa = energy_ratio(self.alpha, self.theta, self.omega)
        kappa1 = abs(complement(self.alpha, self.theta, self.omega)) / a
        s, c = (self.start / 2).sin(), (self.start / 2).cos()
        if self.motion.regime == OSCILLATION:
            self.k, k1, self.rate = kappa.sqrt(), kappa1.sqrt(), a.sqrt()
            sin_phi, cos_phi, dn = s / self.k, w / (2 * (a * kappa).sqrt()), c
        else:
            self.k, k1, self.rate = 1 / kappa.sqrt(), (kappa1 / kappa).sqrt(), (a * kappa).sqrt()
            sin_phi, cos_phi, dn = s, c, w / (2 * self.rate)
        self.K = arb.pi() / (2 * arb(1).agm(k1))
        other = arb.pi() / (2 * arb(1).agm(self.k))
        self.nome_tau = acb(0, other / self.K)
        integral = sin_phi * acb.elliptic_rf(cos_phi**2, dn**2, 1).real  # DLMF 19.25.5
        self.u0 = integral if cos_phi >= 0 else 2 * self.K - integral

    def _jacobi(self, u: arb) -> tuple[arb, arb, arb]:
        zero = acb(0).modular_theta(self.nome_tau)
        at_u = acb(u / (2 * self.K)).modular_theta(self.nome_tau)
        t2, t3, t4 = zero[1], zero[2], zero[3]
        sn = t3 / t2 * at_u[0] / at_u[3]
        cn = t4 / t2 * at_u[1] / at_u[3]
        dn = t4 / t3 * at_u[2] / at_u[3]
        return sn.real, cn.real, dn.real

    def at(self, t: float) -> tuple[arb, arb, int]:
        if self.rests or (t == 0 and self.motion.regime != SEPARATRIX):
            return self.start, arb(self.omega), self.turns
        t = arb(t)
        if self.motion.regime == SEPARATRIX:
            return self._on_separatrix(t)
        if self.motion.regime == OSCILLATION:
            u = self.rate * t + self.u0
            u -= 4 * self.K * floor(u / (4 * self.K) + arb(0.5))
            sn, cn, dn = self._jacobi(u)
            return 2 * atan2(self.k * sn, dn), 2 * self.k * self.rate * cn, self.turns
        sense = 1 if self.omega > 0 else -1
        u = sense * self.rate * t + self.u0
        half_periods = floor(u / (2 * self.K) + arb(0.5))
        sn, cn, dn = self._jacobi(u - 2 * self.K * half_periods)
        return 2 * atan2(sn, cn), sense * 2 * self.rate * dn, self.turns + half_periods

    def _on_separatrix(self, t: arb) -> tuple[arb, arb, int]:
        sense, root = (1 if self.omega > 0 else -1), arb(self.alpha).sqrt()
        x = (self.start / 2).tan().asinh() + sense * root * t
        return 2 * x.sinh().atan(), sense * 2 * root / x.cosh(), self.turns
