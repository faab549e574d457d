// cairn completion: what a shell needs to finish words.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lessons/kit/words.hpp"
#include "lessons/sandbox/scene_words.hpp"
#include "lessons/sandbox/verb.hpp"
#include <cairn/math/list.hpp>

namespace cairn::sandbox {
namespace {

std::string flag_words(const Verb& verb) {
  List<std::string> words;
  for (const List<Flag>* flags : {&verb.flags, &shared_flags()}) {
    for (const Flag& flag : *flags) words.push_back("--" + flag.name);
  }
  return joined(words, " ");
}

/// What can stand behind the verb itself.
std::string place_words(const Verb& verb) {
  if (verb.name == "list") return "scenes solvers stabilizations";
  if (verb.name == "completion") return "bash zsh";
  if (verb.places.find("SCENE") == std::string::npos) return "";
  List<std::string> words;
  for (const SceneEntry& scene : scene_entries()) words.push_back(scene.name);
  return joined(words, " ");
}

/// What can stand behind flags of a closed set.
std::map<std::string, std::string> value_words() {
  return {{"--solver", joined(contestant_names(), " ")},
          {"--solvers", joined(contestant_names(), " ")},
          {"--stabilization", joined(words_of<StabilizationPolicy>(), " ")},
          {"--scalar", joined(words_of<Precision>(), " ")},
          {"--contact-search", joined(words_of<ContactSearch>(), " ")},
          {"--theme", "light dark"},
          {"--size", "small medium large"},
          {"--show", "loads contacts velocities trails overlaps numbers none"},
          {"--color", "auto always never"},
          {"--progress", "auto always never"}};
}

/// Flags whose value is a file or a folder.
std::string file_flags() {
  List<std::string> words;
  for (const Verb& verb : verbs()) {
    for (const Flag& flag : verb.flags) {
      const std::string word = "--" + flag.name;
      if (flag.takes_paths() && std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(word);
    }
  }
  return joined(words, "|");
}

std::string bash_script() {
  List<std::string> names;
  std::string cases, places;
  for (const Verb& verb : verbs()) {
    names.push_back(verb.name);
    cases += fmt::format("    {}) flags=\"{}\" places=\"{}\" ;;\n", verb.name, flag_words(verb),
                         place_words(verb));
  }
  std::string values;
  for (const auto& [flag, words] : value_words()) {
    values += fmt::format("    {}) COMPREPLY=($(compgen -W \"{}\" -- \"$word\")); return ;;\n", flag, words);
  }
  // Files only where a place may be one: scene files.
  return "# Completion of cairn for bash: eval \"$(cairn completion bash)\"\n"
         "_cairn() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} flags= places=\n"
         "  COMPREPLY=()\n"
         "  if [[ $COMP_CWORD == 1 ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         joined(names, " ") +
         " --help --version\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case $before in\n"
         "    " +
         file_flags() + ") COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n" + values +
         "  esac\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$flags\" -- \"$word\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -W \"$places\" -- \"$word\") $(compgen -f -X '!*.toml' -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _cairn cairn\n";
}

/// zsh runs the script of bash.
std::string zsh_script() {
  return "# Completion of cairn for zsh: eval \"$(cairn completion zsh)\"\n"
         "autoload -Uz compinit bashcompinit\n"
         "(( $+functions[compdef] )) || compinit\n"
         "bashcompinit\n" +
         bash_script();
}

int run_completion(const Words& words, Console&) {
  const std::string& shell = words.places.front();
  if (shell != "bash" && shell != "zsh") {
    throw UsageError("cairn completion: the shell must be bash or zsh, got " + shell);
  }
  fmt::print("{}", shell == "bash" ? bash_script() : zsh_script());
  return all_well;
}

}  // namespace

Verb completion_verb() {
  return {
      .name = "completion",
      .places = "bash|zsh",
      .fewest_places = 1,
      .most_places = 1,
      .summary = "a script that lets your shell finish words",
      .idea =
          "Prints the script. To have it in every shell, put the line of the example into ~/.bashrc or "
          "~/.zshrc.",
      .flags = {},
      .examples = {"completion bash > ~/.local/share/bash-completion/completions/cairn", "completion zsh"},
      .run = run_completion};
}

}  // namespace cairn::sandbox
