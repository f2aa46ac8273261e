"""What the peers' programs share: a system from its files, and the memory of a process."""

import json
from pathlib import Path

import numpy as np


class System:
    """A system as `octruss.rs` writes it; the arrays stay in their files until they are copied."""

    def __init__(self, folder):
        def array(name):
            return np.load(Path(folder, f"{name}.npy"), mmap_mode="r")

        description = json.loads(Path(folder, "system.json").read_text())
        self.block, self.rows = description["block"], description["rows"][0]
        self.offsets, self.indices = array("matrix.offsets"), array("matrix.indices")
        self.values = array("matrix.values")
        self.rhs, self.points = array("rhs"), array("points").reshape(-1, 3)

    def rigid_modes(self):
        """The six motions without deformation, one a column, turning about the middle."""
        x, y, z = (self.points - self.points.mean(axis=0)).T
        modes = np.zeros((self.rows, 3, 6))
        modes[:, [0, 1, 2], [0, 1, 2]] = 1
        modes[:, 0, 3], modes[:, 1, 3] = -y, x
        modes[:, 1, 4], modes[:, 2, 4] = -z, y
        modes[:, 0, 5], modes[:, 2, 5] = z, -x
        return modes.reshape(-1, 6)


def resident():
    """Bytes in memory now."""
    return _status("VmRSS:")


def peak():
    """The most bytes that were in memory since the peak was forgotten."""
    return _status("VmHWM:")


def forget_peak():
    """Make the peak the memory in use now."""
    Path("/proc/self/clear_refs").write_text("5")


def _status(name):
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name))
