"""twistbench. Importing it gives this process one thread of linear algebra, whatever the environment says.

Small fits with more threads are up to ten times slower and, because sums are then taken in another order, differ in
their last digits. Runs go side by side as processes instead. The libraries read these variables when they are first
imported, so they are set here, which every program passes before numpy.
"""

import os as _os
import sys as _sys

__version__ = "0.1.0"  # the one place that says it

ONE_THREAD = (
    "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS", "NUMEXPR_NUM_THREADS", "NUMEXPR_MAX_THREADS", "NUMBA_NUM_THREADS",
)  # fmt: skip

for _name in ONE_THREAD:
    if not (_name.startswith("NUMBA") and "numba" in _sys.modules):  # which refuses a change once it runs
        _os.environ[_name] = "1"
if "numpy" in _sys.modules:  # imported by a program that uses twistbench: its libraries read the variables before us
    from threadpoolctl import threadpool_limits as _threadpool_limits

    _threadpool_limits(1)
