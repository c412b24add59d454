# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of the command line of spherical-parameterization in bash: commands, options, values of options, and files.
# What there is to complete is what --help says.

# _spherical_parameterization PROGRAM CURRENT PREVIOUS
_spherical_parameterization()
{
  local program=$1 current=$2 previous=$3 command='' help names kind rest
  local -a words=() options
  COMPREPLY=()

  # readline makes a word of the '=' in --option=value
  if [ "$current" = = ]; then
    current=''
  elif [ "$previous" = = ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  help=$("$program" --help 2>/dev/null) || return
  if [ "$COMP_CWORD" -gt 1 ]; then
    command=${COMP_WORDS[1]}
    [[ $command = -* ]] || help=$("$program" "$command" --help 2>/dev/null) || return
  else
    mapfile -t words < <(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p' <<<"$help")
  fi

  # lines of options are "  -o,--output FILE   ..." or "  --weights {barycentric,conformal}   ..."
  while read -r names kind rest; do
    [[ $names = -* ]] || continue
    IFS=, read -ra options <<<"$names"
    words+=("${options[@]}")
    [[ $previous = -* && ,$names, = *,"$previous",* ]] || continue
    case $kind in
    \{*\})
      kind=${kind#\{}
      mapfile -t COMPREPLY < <(compgen -W "${kind//[,\}]/ }" -- "$current")
      return
      ;;
    FILE* | FOLDER)
      _spherical_parameterization_files "$current"
      return
      ;;
    esac
    # a number or the like; what follows a flag is the first word of its description
    ! [[ $kind =~ ^[[:upper:]|]+$ ]] || return
  done <<<"$help"

  if [[ $current = -* || $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${words[*]}" -- "$current")
  else
    _spherical_parameterization_files "$current" off obj ply stl gii glb gltf gz xz zst bz2
  fi
}

# _spherical_parameterization_files CURRENT [EXTENSION...]: folders, and files with one of the extensions if there are any
_spherical_parameterization_files()
{
  local current=$1 file extensions
  shift
  extensions=" $* "
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if [ $# -eq 0 ] || [ -d "$file" ] || [[ $extensions = *" $(tr '[:upper:]' '[:lower:]' <<<"${file##*.}") "* ]]; then
      COMPREPLY+=("$file")
    fi
  done < <(compgen -f -- "$current")
}

complete -F _spherical_parameterization spherical-parameterization
