"""Words of a diagnosis: every sentence and protocol is made in these rooms, from the content of `diagnosis.json`.

`numbers_page.py` and `physics_page.py`, beside the rooms, are programs: each makes a page of docs/ from sources.
"""
