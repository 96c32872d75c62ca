"""Pack finished materials into one archive: recordings, everything made of them, and how Snakemake made it.

Another lab unpacks it in a checkout of the same version with `python -m pipeline.pack.unpack`.
"""

import hashlib
import zipfile
from pathlib import Path

from .. import __version__
from ..ground.code.fingerprint import fingerprint
from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.parser import Parser
from ..ground.stored.files import sha256, whole
from ..ground.words.counts import counted
from .contents import contents
from .manifest import NAME, File, Manifest

CHUNK_BYTES = 1 << 20
SINCE = (1980, 1, 1, 0, 0, 0)  # no clock in an archive: the manifest has each file's time


def described(path: str, brought: bool) -> File:
    """What a manifest says of a file."""
    state = Path(path).stat()
    return File(state.st_size, sha256(Path(path)), state.st_mtime_ns, brought)


def write(archive: Path, manifest: Manifest, files: dict[str, str]) -> None:
    """Write an archive, whole or not at all; raises BadInput where a file changes meanwhile."""
    with whole(archive) as temporary, zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as zipped:
        zipped.writestr(zipfile.ZipInfo(NAME, SINCE), manifest.to_json(), zipfile.ZIP_DEFLATED)
        for name, file in manifest.files.items():
            if not file.brought:
                continue
            about, digest = zipfile.ZipInfo(name, SINCE), hashlib.sha256()
            about.compress_type, about.file_size = zipfile.ZIP_DEFLATED, file.bytes
            with open(files[name], "rb") as source, zipped.open(about, "w") as target:
                while part := source.read(CHUNK_BYTES):
                    digest.update(part)
                    target.write(part)
            if digest.hexdigest() != file.sha256:
                raise BadInput(files[name], "content", "changed while it was packed", "pack again when nothing writes")


@program
def main() -> None:
    """Write the archive, and say what is in it; Raises BadInput where a material is not finished."""
    parser = Parser(prog=command("pack"), description=__doc__)
    parser.add_argument("material", nargs="*", help="a material that is finished")
    parser.add_argument("--all", action="store_true", help="all materials, and what is made of all of them together")
    parser.add_argument("--without-recordings", action="store_true", help="name recordings by their digests alone")
    parser.add_argument("--configfile", nargs="*", default=[], metavar="FILE", help="as snakemake was given")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="the archive file, such as nylon.zip; required"
    )
    arguments = parser.parse_args()
    if bool(arguments.material) == arguments.all:
        raise BadInput("arguments", "MATERIAL", "names nothing, or something beside --all", "give materials, or --all")
    materials, files = contents(arguments.material, arguments.all, arguments.configfile)
    is_packed = {name: not (arguments.without_recordings and name.startswith("raw/")) for name in files}
    described_files = {name: described(path, is_packed[name]) for name, path in files.items()}
    manifest = Manifest(__version__, fingerprint("pipeline.*"), materials, arguments.configfile, described_files)
    write(arguments.out, manifest, files)
    runs = sum(map(len, materials.values()))
    size = f"{counted(len(described_files), 'file')}, {arguments.out.stat().st_size / 1e6:.1f} MB"
    print(f"{arguments.out}: {', '.join(materials)}, {runs} run{'s' * (runs != 1)}, {size}")


if __name__ == "__main__":
    main()
