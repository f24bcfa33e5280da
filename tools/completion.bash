# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
#
# Completion of fuga's command line in bash: options and commands as `fuga --help` lists them, parameter files,
# directories of results, and the entries that `fuga --print-parameters` knows.

# The entries as Section/Entry= or Section/NAME/Entry=, a line each; names are those of the examples.
_fuga_entries() {
  "$1" --print-parameters 2>/dev/null | awk '
    $1 == "subsection" { sub(/^ *subsection /, ""); path[++depth] = $0; next }
    $1 == "end"        { --depth; next }
    /^ *(# )?set /     { sub(/^ *(# )?set /, ""); sub(/ *=.*/, "")
                         line = ""; for (i = 1; i <= depth; ++i) line = line path[i] "/"
                         print line $0 "=" }'
}

_fuga() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]} word
  local IFS=$'\n'
  COMPREPLY=()
  case $previous in
    --set)
      compopt -o nospace
      for word in $(compgen -W "$(_fuga_entries "$program")" -- "${current//\\/}"); do
        COMPREPLY+=("$(printf %q "$word")")
      done
      ;;
    --output-dir | report)
      compopt -o filenames
      COMPREPLY=($(compgen -d -- "$current"))
      ;;
    --threads) ;;
    *)
      if [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W "$("$program" --help 2>/dev/null | grep -oE -- '--[a-z-]+' | sort -u)" -- "$current"))
      else
        compopt -o filenames
        COMPREPLY=($(compgen -d -- "$current") $(compgen -f -X '!*.@(prm|json)' -- "$current"))
        [[ report == "$current"* ]] && COMPREPLY+=(report)
      fi
      ;;
  esac
}

complete -F _fuga fuga
