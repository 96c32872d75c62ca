"""The paper's INN as FrEIA builds it: the peer that models and queries are measured beside."""

from itertools import pairwise

from FrEIA.framework import SequenceINN
from FrEIA.modules import GLOWCouplingBlock, PermuteRandom
from torch import nn

SIZE, BLOCKS, WIDTH, CLAMP = 5, 7, 256, 2.0


def subnet(inputs: int, outputs: int) -> nn.Sequential:
    """Three fully connected ReLU layers of 256 neurons and a linear output."""
    hidden = [part for a, b in pairwise([inputs, WIDTH, WIDTH, WIDTH]) for part in (nn.Linear(a, b), nn.ReLU())]
    return nn.Sequential(*hidden, nn.Linear(WIDTH, outputs))


def papers_inn() -> SequenceINN:
    """Seven GLOW blocks with random permutations between; its permutations reseed NumPy's generator, not torch's."""
    network = SequenceINN(SIZE)
    for block in range(BLOCKS):
        if block > 0:
            network.append(PermuteRandom, seed=block - 1)
        network.append(GLOWCouplingBlock, subnet_constructor=subnet, clamp=CLAMP)
    return network
