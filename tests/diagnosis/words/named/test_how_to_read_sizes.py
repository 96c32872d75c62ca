"""The sizes of one effect, told apart."""

from made_content import content, page, told


def test_the_details_say_how_to_read_the_sizes_of_one_effect() -> None:
    read = "How to read the sizes of one effect: rms is its usual size over the whole recording; after `up to` stands"
    assert read in told() and "the last column is" not in told() and read not in page()
    assert "the last column is the rms of that part of it" in told(
        content(evidence__beyond_dimensions_mm={"creep": 0.1})
    )


def test_every_size_says_of_which_explanation_it_is() -> None:
    text = told()
    assert "The best explanation: friction_hysteresis + creep\n" in text
    assert "Sizes are those of the best explanation, friction_hysteresis + creep." in text
    assert "this explanation" not in text.partition("What the words mean")[0]
