"""Packages of npm and Debian, got by their own clients, and the files inside them."""

import gzip
import io
import shutil
import subprocess
import tarfile
import zipfile
from pathlib import Path


_ARCHIVES = (".pk3", ".sh3f")  # zip files: maps and players, furniture


class Missing(Exception):
    """Why a package or a file of it is not to be had, in one line."""


def _run(command, folder):
    if shutil.which(command[0]) is None:
        raise Missing(f"{command[0]} is not on this machine")
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = (done.stderr or done.stdout).strip().splitlines()
        raise Missing(f"{' '.join(command)} failed: {lines[-1] if lines else 'it does not say why'}")
    return done.stdout


def _one(folder, pattern, what):
    found = sorted(folder.glob(pattern))
    if not found:
        raise Missing(f"{what} brought no {pattern}")
    return found[-1]


def npm_archive(spec, folder):
    """The .tgz of `name@version`, got with `npm pack` once and kept in `folder`."""
    name, _, version = spec.rpartition("@")
    pattern = f"{name.lstrip('@').replace('/', '-')}-{version}.tgz"
    if not (folder / pattern).exists():
        _run(["npm", "pack", spec, "--silent"], folder)
    return _one(folder, pattern, "npm pack")


def debian_archive(name, version, folder):
    """The .deb of a package in `version`, got with `apt-get download` once and kept in `folder`."""
    pattern = f"{name}_{version.replace(':', '%3a')}_*.deb"
    if not list(folder.glob(pattern)):
        try:
            _run(["apt-get", "download", f"{name}={version}"], folder)
        except Missing:
            # Another release of Debian has another version; the files' hashes decide.
            _run(["apt-get", "download", name], folder)
            pattern = f"{name}_*.deb"
    return _one(folder, pattern, "apt-get download")


def _member_of_tar(tar, path):
    for member in tar:
        if member.name.removeprefix("./") == path and member.isfile():
            return tar.extractfile(member).read()
    raise Missing(f"the package holds no {path}")


class Package:
    """The files of one package, by their paths in it."""

    def __init__(self, source, name, version, folder):
        """Gets the package if it is not in `folder`. Raises Missing if it cannot be had."""
        self._source = source
        if source == "npm":
            self.archive = npm_archive(f"{name}@{version}", folder)
        else:
            self.archive = debian_archive(name, version, folder)
        self._known = {}

    def read(self, path):
        """The bytes of a file; its path may go on inside an archive. Raises Missing if it is not there."""
        for ending in _ARCHIVES:
            outer, separator, inner = path.partition(ending + "/")
            if separator:
                return self._read_zip(self._read(outer + ending), inner)
        return self._read(path)

    def _read_zip(self, archive, path):
        try:
            with zipfile.ZipFile(io.BytesIO(archive)) as pack:
                return pack.read(path)
        except (KeyError, zipfile.BadZipFile) as error:
            raise Missing(f"the archive in the package holds no {path}") from error

    def _read(self, path):
        if path not in self._known:
            try:
                self._known = {path: self._unpacked(path)}  # the last one is asked for again
            except (tarfile.TarError, gzip.BadGzipFile, EOFError) as error:
                raise Missing(f"{self.archive} is damaged: {error}") from error
        return self._known[path]

    def _unpacked(self, path):
        if self._source == "npm":
            with tarfile.open(self.archive) as tar:
                return _member_of_tar(tar, "package/" + path)
        if shutil.which("dpkg-deb") is None:
            raise Missing("dpkg-deb is not on this machine")
        command = ["dpkg-deb", "--fsys-tarfile", str(self.archive)]
        with subprocess.Popen(command, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as unpacking:
            try:
                with tarfile.open(fileobj=unpacking.stdout, mode="r|") as tar:
                    return _member_of_tar(tar, path)
            finally:
                unpacking.stdout.close()

    def unpack(self, folder):
        """Unpacks an npm package into `folder`, without its outer folder."""
        with tarfile.open(self.archive) as tar:
            for member in tar:
                path = Path(member.name)
                if not member.isfile() or path.is_absolute() or ".." in path.parts:
                    continue
                target = folder.joinpath(*path.parts[1:])
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(tar.extractfile(member).read())
