# Completion of the command line of fpkcheck in bash. The program computes the candidates (cli/help.hpp).
_fpkcheck() {
  local word=${COMP_WORDS[COMP_CWORD]} line
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :files) while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -f -- "$word") && compopt -o filenames ;;
      :directories) while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -d -- "$word") && compopt -o filenames ;;
      *=) COMPREPLY+=("$line") && compopt -o nospace ;;
      *) COMPREPLY+=("$line") ;;
    esac
  done < <("${COMP_WORDS[0]}" --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _fpkcheck fpkcheck
