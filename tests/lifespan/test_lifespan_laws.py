import numpy as np
import pytest

from pipeline.lifespan.forecast.fitted_law import fit
from pipeline.lifespan.forecast.law_choice import choose, outliers
from pipeline.lifespan.forecast.laws import LAWS

N = np.arange(1.0, 121.0)
LAW = {law.name: law for law in LAWS}
TRUE = {
    "constant": (0.3 + 0.0 * N, {}),
    "logarithmic": (0.1 + 0.02 * np.log1p(N / 5.0), {"n0": 5.0}),
    "power": (0.1 + 0.01 * N**0.5, {"p": 0.5}),
    "saturating": (0.1 + 0.2 * -np.expm1(-N / 30.0), {"tau": 30.0}),
    "linear": (0.1 + 0.001 * N, {}),
    "saturating, then linear": (0.1 - 0.1 * np.expm1(-N / 8.0) + 0.001 * N, {"tau": 8.0}),
    "linear, then a hyperbola": (0.0005 * N + 0.01 / (1 - N / 200.0), {"N": 200.0}),
    "linear, then a power": (0.0005 * N + 0.1 * (N / 120) ** 4, {"p": 4.0}),
    "linear, then an exponential": (0.0005 * N + 0.002 * np.exp(N / 30.0), {"tau": 30.0}),
}


@pytest.mark.parametrize("name", TRUE)
def test_a_law_recovers_its_own_parameters(name):
    values, nonlinear = TRUE[name]
    fitted = fit(LAW[name], N, values + 1e-4 * np.random.default_rng(0).standard_normal(len(N)))
    for key, value in nonlinear.items():
        assert fitted.parameters()[key] == pytest.approx(value, rel=0.3)
    assert np.abs(fitted.curve(N) - values).max() < 2e-3
    mean, variance = fitted.moments(N)
    assert np.abs(mean - values).max() < 1e-3 and (variance < 1e-5).all()
    drawn = fitted.draws(N, 400, np.random.default_rng(0))
    assert np.abs(drawn.mean(axis=0) - mean).max() < 5e-4
    assert fitted.noise == pytest.approx(1e-4, rel=1.0)


def test_a_line_s_uncertainty_is_that_of_least_squares():
    generator = np.random.default_rng(1)
    off = []
    for _ in range(300):
        fitted = fit(LAW["linear"], N, 0.001 * N + 0.01 * generator.standard_normal(len(N)))
        mean, variance = fitted.moments(np.array([240.0]))
        off.append((mean[0] - 0.24) / np.sqrt(variance[0]))
    assert 0.8 < np.std(off) < 1.1


def test_an_end_only_accelerates():
    drawn = fit(LAW["linear, then a power"], N, -1e-6 * N**2 + 1e-3 * np.sin(N)).draws(N, 200, np.random.default_rng(0))
    assert (np.diff(drawn, 2, axis=1) > -1e-9).all()


def test_too_few_strokes_give_no_fit():
    assert fit(LAW["power"], N[:4], N[:4]) is None


@pytest.mark.parametrize(
    ("name", "alike"),
    [
        ("saturating", {"saturating", "saturating, then linear"}),
        ("linear", {name for name in TRUE if "linear" in name} | {"linear of late", "quadratic of late"}),
        ("logarithmic", {"logarithmic", "logarithmic, then a power"}),
    ],
)
def test_the_law_that_forecasts_is_chosen(name, alike):
    values, _ = TRUE[name]
    choice = choose(N, values + 3e-4 * np.random.default_rng(2).standard_normal(len(N)))
    weights = dict(zip((law_fit.law.name for law_fit in choice.fits), choice.weights, strict=True))
    assert sum(weights[law_name] for law_name in alike) > 0.6, weights
    assert choice.weights.sum() == pytest.approx(1.0)


def test_the_choice_is_by_forecast_and_not_by_fit():
    """A string that turned in its last strokes: what fits all of them best did not foretell them."""
    generator = np.random.default_rng(3)
    values = 0.02 * np.log1p(N) + 2e-4 * generator.standard_normal(len(N))
    choice = choose(N, values)
    by_fit = np.array([law_fit.noise for law_fit in choice.fits])
    assert choice.errors[int(np.argmax(choice.weights))] <= 1.5 * choice.errors.min()
    assert choice.errors[[law_fit.law.name for law_fit in choice.fits].index("linear")] > 5 * choice.errors.min()
    assert by_fit.shape == choice.weights.shape == choice.growth.shape


def test_close_laws_share_the_weight():
    values = 0.05 * np.log1p(N[:25] / 4.0) + 0.01 * np.random.default_rng(4).standard_normal(25)
    assert np.sort(choose(N[:25], values).weights)[-2] > 0.1


def test_outliers_are_left_out():
    values = 0.001 * N + 5e-4 * np.random.default_rng(0).standard_normal(len(N))
    values[40] += 0.05
    assert outliers(values)[40] and outliers(values).sum() <= 3
