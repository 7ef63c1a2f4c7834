"""Packs a folder so that equal contents give equal bytes: sorted names, one time, no owners.

    archive.py PARENT NAME ARCHIVE.tar.gz|.zip        packs PARENT/NAME; the time is SOURCE_DATE_EPOCH, seconds
"""

import gzip
import os
import pathlib
import stat
import sys
import tarfile
import time
import zipfile


def mode(path):
    """Permissions that do not depend on the umask."""
    return 0o755 if path.is_dir() or path.stat().st_mode & stat.S_IXUSR else 0o644


def main():
    parent, name, archive = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    at = int(os.environ["SOURCE_DATE_EPOCH"])
    paths = sorted([parent / name, *(parent / name).rglob("*")], key=lambda path: path.as_posix())
    if archive.endswith(".zip"):
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
            for path in (path for path in paths if path.is_file()):
                entry = zipfile.ZipInfo(path.relative_to(parent).as_posix(), time.gmtime(at)[:6])
                entry.external_attr = (stat.S_IFREG | mode(path)) << 16
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.create_system = 3
                out.writestr(entry, path.read_bytes())
        return
    with (
        open(archive, "wb") as file,
        gzip.GzipFile("", "wb", 9, file, mtime=at) as packed,
        tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as out,
    ):
        for path in paths:
            entry = out.gettarinfo(path, path.relative_to(parent).as_posix())
            entry.mtime, entry.mode = at, mode(path)
            entry.uid, entry.gid, entry.uname, entry.gname = 0, 0, "", ""
            if path.is_file():
                with open(path, "rb") as content:
                    out.addfile(entry, content)
            else:
                out.addfile(entry)


main()
