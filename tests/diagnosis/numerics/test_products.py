"""The products of a fit's columns: made stretch by stretch, they are those of the whole table at once."""

import numpy as np
import pytest

from pipeline.diagnosis.numerics import products
from pipeline.diagnosis.numerics.noise import Noise
from pipeline.diagnosis.numerics.recursions import whiten


@pytest.mark.parametrize("stretch", [40, 97, 10_000])
def test_products_made_stretch_by_stretch_are_those_of_the_whole_table(stretch, monkeypatch):
    monkeypatch.setattr(products, "STRETCH", stretch)
    table = np.random.default_rng(4).standard_normal((5, 300))
    first = np.r_[np.arange(130), np.arange(170)]  # two runs: no filter reaches from one into the other
    noise, prior = Noise(0.4, np.array([0.5, -0.2, 0.1, 0.05, 0.02, 0.1, 0.03]), 0.3), np.arange(4.0)
    table_products = products.Products()
    table_products.hold(table, prior, noise, first)
    white = whiten(table, noise.ar, first) / noise.innovation
    assert table_products.gram == pytest.approx(white[:-1] @ white[:-1].T + np.diag(prior))
    assert table_products.moment == pytest.approx(white[:-1] @ white[-1]) and table_products.square == pytest.approx(
        white[-1] @ white[-1]
    )


def test_plain_products_are_right_in_whatever_order_they_are_asked_for():
    table = np.random.default_rng(5).standard_normal((9, 50))
    table_products = products.Products()
    table_products.hold(table, np.zeros(8), Noise(1.0, np.zeros(0), 1.0), np.arange(50))
    for columns in ([3, 1], [1, 7, 0], [2, 4, 5, 6, 3]):
        gram, moment, square = table_products.raw(np.array(columns))
        assert gram == pytest.approx(table[columns] @ table[columns].T)
        assert moment == pytest.approx(table[columns] @ table[-1]) and square == pytest.approx(table[-1] @ table[-1])


def test_products_gathered_at_once_are_those_gathered_one_by_one(monkeypatch):
    monkeypatch.setattr(products, "TOGETHER", 3)
    table = np.random.default_rng(6).standard_normal((12, 50))
    table_products = products.Products()
    table_products.hold(table, np.zeros(11), Noise(1.0, np.zeros(0), 1.0), np.arange(50))
    table_products.gather(np.array([8, 2]))
    table_products.gather(np.arange(1, 10))
    raw_products = table_products._raw
    gram, moment, _ = table_products.raw(np.arange(1, 10))
    assert table_products._raw is raw_products  # nothing is made twice
    assert gram == pytest.approx(table[1:10] @ table[1:10].T) and moment == pytest.approx(table[1:10] @ table[-1])


def test_what_is_let_go_holds_no_column_and_no_product():
    table_products = products.Products()
    table_products.hold(np.ones((4, 1000)), np.zeros(3), Noise(1.0, np.zeros(0), 1.0), np.arange(1000))
    assert table_products.gram.shape == (3, 3) and table_products.raw(np.array([1]))[2] == 1000.0
    table_products.let_go()
    assert (
        table_products.table.nbytes == 0
        and table_products._raw.nbytes == 0
        and "whitened" not in vars(table_products)
        and table_products.table.base is None
    )
