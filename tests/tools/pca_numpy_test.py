#!/usr/bin/env python3
"""Items P1 to P5 and P8 beside NumPy: its files of every kind in, its singular values as the judge.

    pca_numpy_test.py MIEN    exit 77 where there is no NumPy
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    sys.exit(77)

MIEN = sys.argv[1]
OWN = tempfile.TemporaryDirectory(prefix="mien-test-")  # gone with the test
FOLDER = pathlib.Path(OWN.name)


def mien(*words, fails=False):
    ran = subprocess.run([MIEN, "pca", *map(str, words)], capture_output=True, text=True)
    assert (ran.returncode != 0) == fails, (words, ran.stdout, ran.stderr)
    return ran.stderr if fails else ran.stdout


def basis(path):
    with open(path, "rb") as file:
        info = json.loads(np.load(file).tobytes())
        return info, *(np.load(file) for _ in range(4))


def made(frames, vertices, dimensions, dtype, falling=0.6):
    random = np.random.default_rng(frames * vertices)
    data = random.normal(size=(1, vertices, dimensions)) * 2
    for k in range(10):
        data = data + falling**k * random.normal(size=(frames, 1, 1)) * random.normal(size=(1, vertices, dimensions))
    return data.astype(dtype)


def check(data, count, saved=None):
    """Fits `data` as saved in its own way and holds the result against numpy.linalg.svd."""
    np.save(FOLDER / "a.npy", data if saved is None else saved)
    mien("fit", FOLDER / "a.npy", "-o", FOLDER / "a.basis", "--components", count)
    info, mean, components, variances, weights = basis(FOLDER / "a.basis")
    rows = data.reshape(len(data), -1).astype(np.float64)
    single = data.dtype.itemsize == 4
    assert mean.dtype == components.dtype == weights.dtype == (np.float32 if single else np.float64)
    middle = rows.mean(axis=0)
    _, sigma, right = np.linalg.svd(rows - middle, full_matrices=False)
    flat = components.reshape(count, -1).astype(np.float64)
    close = 1e-6 if single else 1e-9
    assert np.abs(mean.ravel() - middle).max() < close * 10
    assert np.abs(flat @ flat.T - np.eye(count)).max() < close
    for i in range(count):
        if sigma[i] < 1e-6 * sigma[0]:
            assert variances[i] < 1e-11 * variances[0] + 1e-300
            continue
        assert abs(variances[i] * (len(rows) - 1) - sigma[i]**2) < 1e-6 * sigma[i] * sigma[0]
        gaps = [abs(sigma[i] - sigma[j]) / sigma[0] for j in (i - 1, i + 1) if 0 <= j < len(sigma)]
        if min(gaps, default=1) > 1e-3:  # separated: the very vector, up to its sign
            sign = np.sign(flat[i] @ right[i])
            assert np.abs(sign * flat[i] - right[i]).max() < 1e-6, (data.shape, i)
            ours = weights[:, i].astype(np.float64) * sign
            assert np.abs(ours - (rows - middle) @ right[i]).max() < 1e-6 * sigma[0]
    kept = int((sigma[:count] > 1e-6 * sigma[0]).sum())  # the subspace
    outside = right[:kept] - right[:kept] @ flat.T @ flat
    if count == len(sigma) or sigma[kept - 1] - sigma[min(kept, len(sigma) - 1)] > 1e-3 * sigma[0]:
        assert np.abs(outside).max() < 1e-6
    return info


def check_decoding(data, bound):
    """P3, P5: the bound asked for holds on every vertex of every frame as decoded; printed = recomputed."""
    np.save(FOLDER / "a.npy", data)
    mien("fit", FOLDER / "a.npy", "-o", FOLDER / "a.basis", "--max-error", bound)
    mien("decode", FOLDER / "a.basis", "-o", FOLDER / "b.npy")
    back = np.load(FOLDER / "b.npy")
    assert back.shape == data.shape and back.dtype == data.dtype
    errors = np.linalg.norm(back.astype(np.float64) - data.astype(np.float64), axis=2)
    assert errors.max() <= bound
    told = mien("compare", FOLDER / "a.basis", FOLDER / "a.npy")
    words = told.replace(",", "").split()
    assert abs(float(words[2]) - np.sqrt((errors**2).mean())) < 2e-5 * bound, told
    assert abs(float(words[5]) - errors.max()) < 2e-5 * bound, told
    mien("encode", FOLDER / "a.basis", FOLDER / "a.npy", "-o", FOLDER / "w.npy")
    mien("decode", FOLDER / "a.basis", FOLDER / "w.npy", "-o", FOLDER / "c.npy")
    assert np.abs(np.load(FOLDER / "c.npy").astype(np.float64) - back).max() < 1e-5


def check_degenerate():
    """P3, P8: one frame, frames that are all alike, all zero, of low rank: any n from 1 to min(F, V·D), beyond the rank
    orthonormal with variance 0; n = F gives everything back."""
    random = np.random.default_rng(7)
    some = random.normal(size=(1, 7, 3))
    cases = [some, np.repeat(some, 5, 0), np.zeros((4, 3, 2)), random.normal(size=(6, 1, 1)),
             (random.normal(size=(9, 2)) @ random.normal(size=(2, 30))).reshape(9, 10, 3),
             random.normal(size=(8, 2, 3)), random.normal(size=(8, 2, 3)).astype(np.float32)]
    for data in cases:
        np.save(FOLDER / "a.npy", data)
        rows = data.reshape(len(data), -1).astype(np.float64)
        rank = np.linalg.matrix_rank(rows - rows.mean(axis=0))
        close = 1e-6 if data.dtype == np.float32 else 1e-13
        most = min(rows.shape)
        for count in range(1, most + 1):
            mien("fit", FOLDER / "a.npy", "-o", FOLDER / "a.basis", "--components", count)
            _, _, components, variances, _ = basis(FOLDER / "a.basis")
            flat = components.reshape(count, -1).astype(np.float64)
            assert flat.shape[0] == count and np.abs(flat @ flat.T - np.eye(count)).max() < close
            if count > rank:
                assert (variances[rank:] <= 1e-20).all(), variances
        mien("decode", FOLDER / "a.basis", "-o", FOLDER / "b.npy")
        assert np.abs(np.load(FOLDER / "b.npy").astype(np.float64) - data.astype(np.float64)).max() < 10 * close
        mien("fit", FOLDER / "a.npy", "-o", FOLDER / "bad.basis", "--components", most + 1, fails=True)
        assert not (FOLDER / "bad.basis").exists()


def check_info(data):
    """P2: F·V·D → (n + 1)·V·D + F·n numbers."""
    np.save(FOLDER / "a.npy", data)
    mien("fit", FOLDER / "a.npy", "-o", FOLDER / "a.basis", "--components", 3)
    told = mien("info", FOLDER / "a.basis")
    frames, numbers = len(data), data[0].size
    assert f": {data.nbytes} bytes" in told, told
    assert f": {(4 * numbers + 3 * frames) * data.itemsize} bytes" in told, told


def check_bad():
    """What is wrong is one sentence, and nothing is written."""
    data = made(4, 3, 3, np.float32)
    np.save(FOLDER / "a.npy", data)
    whole = (FOLDER / "a.npy").read_bytes()
    cases = {"cut": whole[:-4], "long": whole + b"0", "no": b"hello"}
    for name, content in cases.items():
        (FOLDER / f"{name}.npy").write_bytes(content)
    np.save(FOLDER / "complex.npy", data.astype(np.complex64))
    np.savez(FOLDER / "archive.npz", frames=data)
    (FOLDER / "archive.npz").rename(FOLDER / "archive.npy")
    np.save(FOLDER / "flat.npy", data.ravel())
    data[2, 1, 0] = np.nan
    np.save(FOLDER / "nan.npy", data)
    np.save(FOLDER / "object.npy", np.array([{}, {}], dtype=object), allow_pickle=True)
    for name in [*cases, "complex", "archive", "flat", "nan", "object", "none"]:
        said = mien("fit", FOLDER / f"{name}.npy", "-o", FOLDER / "bad.basis", "--components", 1, fails=True)
        assert said.count("\n") == 1 and f"{name}.npy: " in said, said
        assert not (FOLDER / "bad.basis").exists()
    for count in (0, 5, "x"):
        said = mien("fit", FOLDER / "a.npy", "-o", FOLDER / "bad.basis", "--components", count, fails=True)
        assert said.count("\n") == 1 and not (FOLDER / "bad.basis").exists(), said
    assert not list(FOLDER.glob(".mien-*"))


def main():
    for dtype in (np.float32, np.float64):
        for shape, count in [((30, 50, 3), 7), ((200, 8, 3), 24), ((12, 90, 2), 12), ((40, 13, 3), 39), ((5, 4, 1), 1)]:
            check(made(*shape, dtype), count)
    data = made(20, 30, 3, np.float32)
    check(data, 6, saved=np.asfortranarray(data))
    check(data, 6, saved=data.astype(">f4"))
    check(data, 6, saved=np.asfortranarray(data.astype(">f4")))
    check(made(20, 30, 3, np.float64), 6, saved=made(20, 30, 3, np.float64).astype(">f8"))
    whole = np.clip(np.rint(made(20, 30, 3, np.float64) * 10), -127, 127)
    for dtype in (np.int8, np.int16, np.int32, np.int64, ">i2", ">i8", np.float16):
        check(whole, 6, saved=whole.astype(dtype))
    for dtype in (np.uint8, np.uint16, np.uint32, ">u8"):
        check(np.abs(whole), 6, saved=np.abs(whole).astype(dtype))
    for dtype in (np.float32, np.float64):
        for bound in (2.0, 0.05):
            check_decoding(made(60, 40, 3, dtype), bound)
    check_degenerate()
    check_info(made(33, 21, 3, np.float32))
    check_bad()


main()
