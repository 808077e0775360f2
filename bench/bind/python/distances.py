#!/usr/bin/env python3
"""A million distances to a quadratic Bézier curve from Python, beside NumPy: what docs/python.md says of times.

    MIEN_LIBRARY=build/release PYTHONPATH=bind/python python3 bench/bind/python/distances.py [--points N] [--rounds N]

All ways take turns in one process, on points in a square around the curve; the figures are medians over the rounds. Two threads
then measure at once: the kernels let go of Python's lock.
"""
import argparse
import statistics
import threading
import time

import numpy

from mien import distance

CURVE = numpy.array([[0.0, 0.0], [0.5, 1.0], [1.0, 0.2]])


def closed_form(points, x, y):
    """The distance by the closed forms of the foot's cubic, Viète's cosines and Cardano's roots, in whole arrays."""
    a, b, c = points
    step, bend = b - a, a - 2 * b + c
    dx, dy = a[0] - x, a[1] - y
    third = bend @ bend                                   # t³ third + 3 t² second + t first + zeroth
    second = 3 * (step @ bend) / third
    first = (2 * (step @ step) + dx * bend[0] + dy * bend[1]) / third
    zeroth = (dx * step[0] + dy * step[1]) / third
    p, q = first - second * second / 3, zeroth - second * first / 3 + 2 * second**3 / 27
    discriminant = q * q / 4 + p**3 / 27
    one = discriminant >= 0
    root = numpy.sqrt(numpy.where(one, discriminant, 0))
    cardano = numpy.cbrt(-q / 2 + root) + numpy.cbrt(-q / 2 - root)
    radius = numpy.sqrt(numpy.where(one, 1, -p / 3))
    angle = numpy.arccos(numpy.clip(numpy.where(one, 0, -q / (2 * radius**3)), -1, 1)) / 3
    nearest = numpy.full(numpy.shape(p), numpy.inf)
    for turn in range(3):
        t = numpy.where(one, cardano, 2 * radius * numpy.cos(angle - turn * 2 * numpy.pi / 3)) - second / 3
        t = numpy.clip(t, 0, 1)
        ex, ey = dx + t * (2 * step[0] + t * bend[0]), dy + t * (2 * step[1] + t * bend[1])
        nearest = numpy.minimum(nearest, ex * ex + ey * ey)
    return numpy.sqrt(nearest)


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def at_once(*works):
    threads = [threading.Thread(target=work) for work in works]
    for one in threads:
        one.start()
    for one in threads:
        one.join()


def main():
    asked = argparse.ArgumentParser()
    asked.add_argument("--points", type=int, default=1_000_000)
    asked.add_argument("--rounds", type=int, default=21)
    asked = asked.parse_args()
    x, y = numpy.random.default_rng(1).uniform(-1, 2, (2, asked.points))
    singles = x.astype("f4"), y.astype("f4")
    out, single_out, other_out = numpy.empty_like(x), numpy.empty_like(singles[0]), numpy.empty_like(x)
    furthest = numpy.max(numpy.abs(closed_form(CURVE, x, y) - distance.quad(CURVE, x, y)))
    assert furthest < 1e-6, furthest  # both answer the same question

    def ten_times(place):
        for _ in range(10):
            distance.quad(CURVE, x, y, out=place)

    def in_turn():
        ten_times(out)
        ten_times(other_out)

    ways = {
        "NumPy, closed form, float64": lambda: closed_form(CURVE, x, y),
        "NumPy, closed form, float32": lambda: closed_form(CURVE.astype("f4"), *singles),
        "mien, float64": lambda: distance.quad(CURVE, x, y, out=out),
        "mien, float32": lambda: distance.quad(CURVE, *singles, out=single_out),
    }
    both = {"in turn": in_turn, "at once": lambda: at_once(lambda: ten_times(out), lambda: ten_times(other_out))}
    took = {name: [] for name in [*ways, *both]}
    for _ in range(asked.rounds):
        for name, work in [*ways.items(), *both.items()]:
            took[name].append(seconds(work))
    print(f"{asked.points} points, {asked.rounds} rounds, largest difference {furthest:.1e}")
    for name in ways:
        print(f"{name:30} {statistics.median(took[name]) / asked.points * 1e9:8.2f} ns a point")
    faster = statistics.median(before / after for before, after in zip(took["in turn"], took["at once"]))
    print(f"two threads, ten calls each: {faster:.2f} times as fast as one after the other")


if __name__ == "__main__":
    main()
