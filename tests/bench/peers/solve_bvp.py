"""Geodesics between two points by scipy's solve_bvp on the geodesic equations, as a user would write them with numpy.

Input, JSON: {"surface": "saddle" | "dini", "pairs": [[u, v, u, v], ...], "tolerances": [...], "rounds": n}.
Output, JSON: a list of {"pair", "tolerance", "seconds" (the least of all rounds), "length" (null: not solved)}.
"""

import json
import sys
import time

import numpy as np
from scipy.integrate import solve_bvp


def saddle(u, v):
    """First and second derivatives of (u, v, u^2 - v^2): S_u, S_v, S_uu, S_uv, S_vv."""
    zero, one = np.zeros_like(u), np.ones_like(u)
    return (
        np.array([one, zero, 2 * u]),
        np.array([zero, one, -2 * v]),
        np.array([zero, zero, 2 * one]),
        np.array([zero, zero, zero]),
        np.array([zero, zero, -2 * one]),
    )


def dini(u, v):
    """The same of Dini's surface, 2 (cos u sin v, sin u sin v, cos v + log tan(v/2) + 0.4 u)."""
    cu, su, cv, sv = np.cos(u), np.sin(u), np.cos(v), np.sin(v)
    zero, one = np.zeros_like(u), np.ones_like(u)
    return (
        2 * np.array([-su * sv, cu * sv, 0.4 * one]),
        2 * np.array([cu * cv, su * cv, 1 / sv - sv]),
        2 * np.array([-cu * sv, -su * sv, zero]),
        2 * np.array([-su * cv, cu * cv, zero]),
        2 * np.array([-cu * sv, -su * sv, -cv / (sv * sv) - cv]),
    )


def dot(a, b):
    return np.sum(a * b, axis=0)


def equations(surface):
    """y = (u, v, u', v'): the second derivatives are those that make the acceleration normal to the surface."""

    def derivatives(_, y):
        u, v, p, q = y
        s_u, s_v, s_uu, s_uv, s_vv = surface(u, v)
        acceleration = s_uu * p * p + 2 * s_uv * p * q + s_vv * q * q
        e, f, g = dot(s_u, s_u), dot(s_u, s_v), dot(s_v, s_v)
        a, b = dot(s_u, acceleration), dot(s_v, acceleration)
        determinant = e * g - f * f
        return np.array([p, q, (f * b - g * a) / determinant, (f * a - e * b) / determinant])

    return derivatives


def length_of(surface, solution):
    """Integral of the speed, by Simpson's rule: not timed."""
    t = np.linspace(0, 1, 2001)
    u, v, p, q = solution.sol(t)
    s_u, s_v = surface(u, v)[:2]
    speed = np.sqrt(dot(s_u, s_u) * p * p + 2 * dot(s_u, s_v) * p * q + dot(s_v, s_v) * q * q)
    return float((speed[0] + speed[-1] + 4 * speed[1:-1:2].sum() + 2 * speed[2:-1:2].sum()) / 6000)


def solve(surface, pair, tolerance):
    a, b = np.array(pair[:2]), np.array(pair[2:])
    t = np.linspace(0, 1, 17)
    straight = np.vstack([np.outer(a, 1 - t) + np.outer(b, t), np.outer(b - a, np.ones_like(t))])
    ends = lambda ya, yb: np.concatenate([ya[:2] - a, yb[:2] - b])
    return solve_bvp(equations(surface), ends, t, straight, tol=tolerance, max_nodes=5000)


def main():
    task = json.load(sys.stdin)
    surface = {"saddle": saddle, "dini": dini}[task["surface"]]
    rows = []
    for pair_index, pair in enumerate(task["pairs"]):
        for tolerance in task["tolerances"]:
            least = np.inf
            for _ in range(task["rounds"]):
                start = time.perf_counter()
                solution = solve(surface, pair, tolerance)
                least = min(least, time.perf_counter() - start)
            length = length_of(surface, solution) if solution.status == 0 else None
            rows.append({"pair": pair_index, "tolerance": tolerance, "seconds": least, "length": length})
    json.dump(rows, sys.stdout)


main()
