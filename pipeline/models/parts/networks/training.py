"""The training loop that the networks share: shuffled batches, Adam, one learning rate an epoch.

Source: Kingma and Ba, "Adam: a method for stochastic optimization", ICLR 2015.
"""

import inspect
import io
import logging
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NotRequired, TypedDict

import torch
from pydantic import JsonValue
from torch import Tensor, nn

from ....ground.words.progress import steps
from ..box import SavedBox
from ..saved import read_bytes, write_bytes

log = logging.getLogger(__name__)


class SavedNetwork(TypedDict):
    """A network as its file holds it: settings, mean and spread of each side's columns, and weights by layer."""

    settings: dict[str, JsonValue]
    scalings: list[Tensor]
    weights: dict[str, Tensor]
    conditions: NotRequired[dict[str, list[object]]]
    box: NotRequired[SavedBox]
    shift_mm: NotRequired[float]


def write_weights(path: Path, content: SavedNetwork) -> None:
    """Write a network's settings, scalings and weights with their check sum, whole or not at all."""
    packed = io.BytesIO()
    torch.save(content, packed)
    write_bytes(path, packed.getvalue())


def read_weights(path: Path) -> SavedNetwork:
    """The content that `write_weights` wrote; raises BadInput for a damaged file, anything for another model."""
    content: SavedNetwork = torch.load(io.BytesIO(read_bytes(path)), weights_only=True)
    return content


@contextmanager
def repeatable(seed: int) -> Iterator[None]:
    """Make the code inside give the same numbers for the same seed, and leave torch's own generator unchanged.

    One thread: sums do not depend on the number of cores, and on shared cores two threads are slower.
    """
    torch.set_num_threads(1)
    torch.set_deterministic_debug_mode("error")  # as use_deterministic_algorithms, which imports torch's compiler
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        yield


def tensor(values: object) -> Tensor:
    """An array as a float32 tensor. It keeps its shape, and stays in its unit."""
    return torch.as_tensor(values, dtype=torch.float32)


class Adam(torch.optim.Adam):
    """Adam of torch, without its mark for torch's compiler: the mark imports the compiler, 2 s a process."""

    add_param_group = inspect.unwrap(torch.optim.Adam.add_param_group)
    zero_grad = inspect.unwrap(torch.optim.Adam.zero_grad)
    step = torch.no_grad()(inspect.unwrap(torch.optim.Adam.step))


def minimise(
    network: nn.Module, loss_of: Callable[[Tensor], Tensor], points: int, batch: int, rates: Sequence[float]
) -> None:
    """Lower a loss by Adam with the given learning rate in each epoch; `loss_of` takes a batch's row numbers.

    Shows the epochs as progress and logs the last one's mean loss. Raises ArithmeticError when the loss is not finite.
    Row numbers have the shape (batch,), as indices.
    """
    optimiser = Adam(network.parameters(), lr=rates[0], fused=True)
    batches = math.ceil(points / batch)
    for epoch, rate in enumerate(steps(rates, "epoch"), start=1):
        optimiser.param_groups[0]["lr"] = rate
        total = torch.zeros(())
        # Batches of equal size: a last one of a few rows would shake the weights as much as a full one.
        for rows in torch.randperm(points).tensor_split(batches):
            optimiser.zero_grad()
            loss = loss_of(rows)
            loss.backward()
            optimiser.step()
            total += loss.detach()
        mean = float(total) / batches
        if not math.isfinite(mean):
            raise ArithmeticError(f"the loss is {mean} in epoch {epoch} of {len(rates)}")
    log.info("epoch %d of %d, loss %.3g", epoch, len(rates), mean)
