# Virtual environments of Python, sourced by the scripts in this folder.

# environment FOLDER REQUIREMENTS PYTHON: creates the virtual environment if its requirements have changed. The copy of
# the requirements is written last, so that an incomplete environment is created again.
environment() {
  if ! cmp -s "$2" "$1/requirements.txt"; then
    rm -rf "$1"
    "$3" -m venv "$1"
    "$1/bin/pip" install --quiet --disable-pip-version-check --requirement "$2"
    cp "$2" "$1/requirements.txt"
  fi
}

# The first program that runs (pyenv adds programs to the path that do not run), else python3.
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
