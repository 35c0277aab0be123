# Words of the window program for bash; those of velum-batch it makes itself (velum-batch completion bash).
_velum() {
  local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}"
  case "$before" in
    --language) COMPREPLY=($(compgen -W 'en de' -- "$word")); return ;;
  esac
  case "$word" in
    -*) COMPREPLY=($(compgen -W '--help --help-all --version --screenshot --script --echo --language' -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}
complete -o filenames -F _velum velum
