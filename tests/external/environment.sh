# Virtual environments of Python, sourced by the scripts in this folder.

# environment FOLDER PYTHON REQUIREMENTS...: creates the virtual environment, unless it has all that the files require. The copy of
# the requirements is written last, so that an incomplete environment is created again.
environment() {
  local folder=$1 python=$2 file missing=''
  shift 2
  for file in "$@"; do
    grep -qvxFf "$folder/requirements.txt" "$file" 2> /dev/null && missing=1
  done
  if [ -n "$missing" ] || [ ! -e "$folder/requirements.txt" ]; then
    rm -rf "$folder"
    "$python" -m venv "$folder"
    "$folder/bin/pip" install --quiet --disable-pip-version-check --no-compile "${@/#/--requirement=}"
    cat "$@" > "$folder/requirements.txt"
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
