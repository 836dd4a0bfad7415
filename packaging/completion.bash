# Completes subcommands and options of asperity, which says itself what they are, and file names.
_asperity() {
    local word=${COMP_WORDS[COMP_CWORD]} command="" i
    for ((i = 1; i < COMP_CWORD; i++)); do
        if [[ ${COMP_WORDS[i]} != -* ]]; then
            command=${COMP_WORDS[i]}
            break
        fi
    done
    local help
    if [[ $word == -* ]]; then
        help=$(asperity $command --help 2>/dev/null || asperity --help 2>/dev/null)
        mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '(^|[ ,])--?[a-z][a-z0-9-]*' <<<"$help" | tr -d ' ,' | sort -u)" -- "$word")
        return
    fi
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    if [[ -z $command ]]; then
        help=$(asperity --help 2>/dev/null | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p')
        local subcommands
        mapfile -t subcommands < <(compgen -W "$help" -- "$word")
        COMPREPLY+=("${subcommands[@]}")
    fi
}
complete -o filenames -F _asperity asperity
