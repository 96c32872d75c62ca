"""The site of docs/: built strictly, every link within it leads somewhere, and nothing in it comes from elsewhere."""

import html.parser
import json
import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

import pipeline

DOCS = Path(__file__).parents[2] / "docs"
ELSEWHERE = r"(?:https?:)?//([\w.-]+)"  # an address on another host
NAMESPACE = "www.w3.org"  # names a vocabulary, and is not asked
LOADED = {("script", "src"), ("link", "href"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(html.parser.HTMLParser):
    """What a page links to, what it loads, and the places in it that a link can name."""

    def __init__(self, text: str):
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for key, value in attrs:
            if key == "id":
                self.places.add(value)
            elif (tag, key) in LOADED:
                self.loaded.append(value)
            elif (tag, key) == ("a", "href"):
                self.links.append(value)


def build(docs, out, *, state):
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-d", str(state), str(docs), str(out)]
    return subprocess.run(command, capture_output=True, text=True, cwd=DOCS.parent)


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    out = tmp_path_factory.mktemp("site")
    done = build(DOCS, out / "html", state=out / "state")
    assert done.returncode == 0, done.stderr
    return out / "html"


@pytest.fixture(scope="module")
def pages(site):
    return {
        path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html") if "_static" not in path.parts
    }


@pytest.mark.long
def test_every_link_within_the_site_leads_to_a_page_and_a_place_in_it(site, pages):
    followed = 0
    for path, page in pages.items():
        for link in page.links:
            url = urlsplit(link)
            if url.scheme:
                continue
            target = (path.parent / unquote(url.path)).resolve() if url.path else path
            assert target.is_file(), f"{path.relative_to(site)}: {link}"
            if url.fragment and target.suffix == ".html":
                assert unquote(url.fragment) in pages[target].places, f"{path.relative_to(site)}: {link}"
            followed += 1
    assert followed > 500


@pytest.mark.long
def test_no_page_loads_anything_from_another_host(site, pages):
    loaded = [(path, address) for path, page in pages.items() for address in page.loaded]
    assert len(loaded) > 100
    for path, address in loaded:
        url = urlsplit(address)
        if url.scheme == "data" or address == "#":
            continue
        assert not url.scheme and not url.netloc, f"{path.relative_to(site)}: {address}"
        assert (path.parent / unquote(url.path)).is_file(), f"{path.relative_to(site)}: {address}"
    for style in (*site.rglob("*.css"), *pages):
        foreign_urls = re.findall(rf"(?:url\(|@import)\s*[\"']?\s*{ELSEWHERE}", style.read_text(encoding="utf-8"))
        assert not foreign_urls, style
    for script in site.rglob("*.js"):
        named = re.findall(rf"[\"'`]{ELSEWHERE}", script.read_text(encoding="utf-8"))
        assert script.name == "searchindex.js" or set(named) <= {NAMESPACE}, script


@pytest.mark.long
def test_every_page_of_docs_is_on_the_site_and_in_its_navigation(site, pages):
    aside = site / "search.html"  # which links to nothing but what stands beside every page
    led = {site / urlsplit(link).path for link in pages[aside].links}
    for source in [*DOCS.glob("*.md"), *DOCS.glob("tutorial/*.ipynb")]:
        page = site / source.relative_to(DOCS).with_suffix(".html")
        assert page in led, source.name
    captions = re.findall(r'class="caption".*?>([^<>]+)</span>', aside.read_text(encoding="utf-8"))
    assert captions == ["Begin", "How to", "Look up", "Understand"]


@pytest.mark.long
def test_the_reference_has_every_public_name(site, pages):
    places = pages[site / "api.html"].places
    assert {f"twistbench.{name}" for name in pipeline.__all__} <= places
    assert {"twistbench.Diagnosis.verdict", "twistbench.Recording.strokes"} <= places
    assert "twistbench.FittedModel.forward" in places


@pytest.mark.long
def test_the_search_finds_a_mechanism(site):
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    search_index = json.loads(index[index.index("{") : index.rindex("}") + 1])
    assert "creep" in search_index["terms"] and "protocol" in search_index["docnames"]


@pytest.mark.long
def test_the_tutorial_shows_what_its_cells_gave(site):
    book = json.loads((DOCS / "tutorial" / "tutorial.ipynb").read_text(encoding="utf-8"))
    text = (site / "tutorial" / "tutorial.html").read_text(encoding="utf-8")
    pictures = sum(
        "image/png" in output.get("data", {}) for cell in book["cells"] for output in cell.get("outputs", [])
    )
    assert pictures and text.count('alt="what the cell shows"') == pictures


@pytest.mark.long
def test_a_dead_link_fails_the_build(tmp_path):
    docs = tmp_path / "docs"
    docs.mkdir()
    configuration = (DOCS / "conf.py").read_text().replace("DOCS.parent", f"Path({str(DOCS.parent)!r})")
    (docs / "conf.py").write_text(configuration)
    for text, works in (("# A page\n\n[here](#a-page)\n", True), ("# A page\n\n[there](no_page.md)\n", False)):
        (docs / "index.md").write_text(text)
        assert (build(docs, tmp_path / "out", state=tmp_path / "state").returncode == 0) is works
