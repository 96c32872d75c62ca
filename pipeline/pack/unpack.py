"""Unpack an archive of `python -m pipeline.pack` in a project's folder, so that Snakemake finds what is made.

Every file is checked before the first is put in its place. `raw/` is never rewritten: a recording that is there must be
the one that the archive names. Digests show damage; they do not show who packed it.
"""

import errno
import hashlib
import os
import shlex
import shutil
import stat
import zipfile
import zlib
from pathlib import Path

from ..ground.code.fingerprint import fingerprint
from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.parser import Parser
from ..ground.stored.files import make_folders, sha256
from ..ground.words.counts import counted
from .manifest import MEND, NAME, PLACES, PROVENANCE, File, Manifest, read
from .provenance import NOTES, note_of

CHUNK_BYTES = 1 << 20
LARGEST_MANIFEST = 1 << 28
WHOLE = "fetch it again, whole"


def manifest_of(zipped: zipfile.ZipFile, archive: Path) -> Manifest:
    """The manifest of an open archive that holds the files that it names, once each, and no other; raises BadInput."""
    names = [about.filename for about in zipped.infolist()]
    if names[:1] != [NAME] or zipped.infolist()[0].file_size > LARGEST_MANIFEST:
        raise BadInput(archive, NAME, "does not come first", MEND)
    for about in zipped.infolist():
        kind = stat.S_IFMT(about.external_attr >> 16)
        if kind not in (0, stat.S_IFREG) or about.flag_bits & 1:
            raise BadInput(archive, about.filename, "is a link, a folder, a device or encrypted, no plain file", MEND)
    manifest = read(zipped.read(NAME), archive)
    brought = {name for name, file in manifest.files.items() if file.brought}
    if len(set(names)) != len(names) or set(names[1:]) != brought:
        odd = next(iter(sorted(set(names[1:]) ^ brought)), "a file that comes twice")
        raise BadInput(archive, ascii(odd)[:200], "is in the archive or in its manifest, not in both", MEND)
    need = sum(file.bytes for file in manifest.files.values() if file.brought)
    free = shutil.disk_usage(Path()).free
    if need > free:
        raise BadInput(archive, "files", f"need {need / 1e9:.1f} GB, and {free / 1e9:.1f} are free", "make room")
    return manifest


def made_of(note: str) -> str:
    """The file or folder whose making a note of an archive tells."""
    return note.removeprefix(f"{PROVENANCE}/").removesuffix(".json")


def target_of(name: str) -> Path:
    """Where a file of an archive belongs in this folder."""
    return note_of(Path(), made_of(name)) if name.startswith(f"{PROVENANCE}/") else Path(name)


def missing(manifest: Manifest, archive: Path) -> list[str]:
    """Names of the files that this folder lacks; raises BadInput where another stands in the place of one."""
    lacking, notes = [], []
    for name, file in manifest.files.items():
        target = target_of(name)
        above = next((path for path in target.parents if os.path.lexists(path) and not path.is_dir()), None)
        if above or (os.path.lexists(target) and not target.is_file()):
            raise BadInput(above or target, "file", f"is in the way of {name}", "unpack in a fresh checkout")
        if name.startswith(f"{PROVENANCE}/"):
            notes.append(name)
        elif not target.exists():
            if name.startswith("raw/") and (target.parent.exists() or not file.brought):
                mend = "put the recording there, or ask for an archive with recordings"
                raise BadInput(target, "recording", "is not there, and raw/ is never added to", mend)
            lacking.append(name)
        elif target.stat().st_size != file.bytes or sha256(target) != file.sha256:
            mend = "unpack in a fresh checkout" + ("" if name.startswith("raw/") else ", or remove the file")
            raise BadInput(target, "content", f"is another than {archive.name} holds; nothing is replaced", mend)
    coming = {str(path) for name in lacking for path in (Path(name), *Path(name).parents)}
    return lacking + [name for name in notes if made_of(name) in coming or not target_of(name).exists()]


def bring(zipped: zipfile.ZipFile, name: str, file: File, place: Path, archive: Path) -> None:
    """Write one file of an archive below a temporary folder; raises BadInput where it is not what was packed."""
    temporary, digest, bytes_left = place / name, hashlib.sha256(), file.bytes
    make_folders(temporary.parent)
    try:
        with zipped.open(name) as source, temporary.open("wb") as target:
            while part := source.read(min(CHUNK_BYTES, bytes_left + 1)):
                bytes_left -= len(part)
                if bytes_left < 0:
                    break
                digest.update(part)
                target.write(part)
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, ValueError) as error:
        raise BadInput(archive, name, f"is damaged ({error})", WHOLE) from None
    if bytes_left or digest.hexdigest() != file.sha256:
        raise BadInput(archive, name, "is not what was packed: its digest is another", WHOLE)
    os.chmod(temporary, 0o444 if name.startswith("raw/") else 0o644)
    os.utime(temporary, ns=(file.time_ns, file.time_ns))


def move(source: Path, target: Path) -> None:
    """Put a file or a folder in its place in one step, also where raw/ or processed/ leads to another disk."""
    try:
        os.replace(source, target)
        return
    except OSError as error:
        if error.errno != errno.EXDEV:
            raise
    beside = target.with_name(f".{target.name}.unpack.{os.getpid()}")
    try:
        if source.is_dir():
            shutil.copytree(source, beside)
        else:
            shutil.copy2(source, beside)
        os.replace(beside, target)
    except BaseException:
        shutil.rmtree(beside, ignore_errors=True)
        beside.unlink(missing_ok=True)
        raise


def settle(place: Path, names: list[str]) -> None:
    """Move what was checked to where it belongs, what others stand on first; a recording's folder whole."""
    for run in sorted({name.split("/")[1] for name in names if name.startswith("raw/")}):
        Path("raw").mkdir(exist_ok=True)
        move(place / "raw" / run, Path("raw", run))
    (NOTES.parent / "incomplete").mkdir(parents=True, exist_ok=True)  # without it Snakemake takes notes for old ones
    for name in sorted(names, key=lambda name: PLACES.index(name.partition("/")[0])):
        if not name.startswith("raw/"):
            target = target_of(name)
            target.parent.mkdir(parents=True, exist_ok=True)
            move(place / name, target)


def unpack(archive: Path) -> tuple[Manifest, int]:
    """Put what this folder lacks in its place, and return the manifest and the number of files; raises BadInput."""
    place = Path(f".unpack.{os.getpid()}")
    try:
        with zipfile.ZipFile(archive) as zipped:
            manifest = manifest_of(zipped, archive)
            names = missing(manifest, archive)
            for name in names:
                bring(zipped, name, manifest.files[name], place, archive)
        settle(place, names)
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError) as error:
        raise BadInput(archive, "archive", f"is not whole, or no archive of ours ({error})", WHOLE) from None
    finally:
        shutil.rmtree(place, ignore_errors=True)
    return manifest, len(names)


@program
def main() -> None:
    """Unpack, and say what came and what Snakemake may make again."""
    parser = Parser(prog=command("pack.unpack"), description=__doc__)
    parser.add_argument("archive", type=Path, metavar="FILE", help="what python -m pipeline.pack wrote")
    archive: Path = parser.parse_args().archive
    if not archive.is_file():
        raise BadInput(archive, "archive", "is no file", "give what python -m pipeline.pack wrote")
    if not Path("Snakefile").is_file():
        raise BadInput("Snakefile", "folder", "is no project", "start in the folder of a checkout of twistbench")
    manifest, came = unpack(archive)
    kept_count = len(manifest.files) - came
    print(
        f"{', '.join(manifest.materials)}: {counted(came, 'file')} unpacked"
        + (f", {kept_count} {'was' if kept_count == 1 else 'were'} there" if kept_count else "")
    )
    if fingerprint("pipeline.*") != manifest.code:
        print(f"packed by other code (twistbench {manifest.version}): what that code makes otherwise is made again")
    configured = shlex.join(["--configfile", *manifest.configuration]) if manifest.configuration else ""
    print(f"now: snakemake --cores 2 {configured}".rstrip())


if __name__ == "__main__":
    main()
