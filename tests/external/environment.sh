# Sourced by the scripts beside it: virtual environments of Python.

# environment FOLDER REQUIREMENTS PYTHON: makes the virtual environment where its requirements have changed. Their copy is written
# last, so that an environment that was only half made is made again.
environment() {
  if ! cmp -s "$2" "$1/requirements.txt"; then
    rm -rf "$1"
    "$3" -m venv "$1"
    "$1/bin/pip" install --quiet --disable-pip-version-check --requirement "$2"
    cp "$2" "$1/requirements.txt"
  fi
}

# The first that runs (pyenv puts programs into the path that do not), else python3.
first() {
  local python
  for python in "$@"; do
    if "$python" -c "import venv, ensurepip" 2> /dev/null; then
      echo "$python"
      return
    fi
  done
  echo python3
}
