"""What mkdocs does beyond mkdocs.yml: takes in the pages beside docs/, the notebooks and the pages of
effects, keeps links inside of the site, and copies what draws formulas."""
import base64
import json
import logging
import os
import posixpath
import re
import shutil
import tempfile

from mkdocs.structure.files import File

log = logging.getLogger("mkdocs.pendular")

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# Pages beside docs/, by their path in the site.
BESIDE = {"overview.md": "README.md", **{name: name for name in ("ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md")}}
KATEX = "/usr/share/javascript/katex"
JQUERY = "/usr/share/javascript/jquery/jquery.min.js"
# Debian's theme asks for these two scripts without having them.
MISSING = {
    "jquery-3.6.0.min.js": JQUERY,
    # A page that is opened from the disk cannot read the index of words in a worker, as the theme does:
    # it loads lunr and the index as scripts, and answers in the worker's place.
    "theme_extra.js": """if (location.protocol === "file:") window.Worker = class {
  constructor(path) { this.folder = path.replace(/worker[.]js$/, ""); }
  script(name) {
    return new Promise(loaded => {
      const script = document.createElement("script");
      script.src = this.folder + name;
      script.onload = loaded;
      document.head.append(script);
    });
  }
  async postMessage({init, query}) {
    if (!init) {
      const found = this.index.search(query).map(({ref}) => this.documents.get(ref));
      this.onmessage({data: {results: found.map(page => ({...page, summary: page.text.slice(0, 200)}))}});
      return;
    }
    await this.script("lunr.js");
    await this.script("search_index.js");
    const {config, docs} = window.search_index;
    this.documents = new Map(docs.map(page => [page.location, page]));
    lunr.tokenizer.separator = new RegExp(config.separator);
    this.index = lunr(function() {
      this.field("title"), this.field("text"), this.ref("location");
      for (const page of docs) this.add(page);
    });
    this.onmessage({data: {config}});
    this.onmessage({data: {allowSearch: true}});
  }
};
$(() => {
  $("head").append("<style>.wy-table-responsive table td, .wy-table-responsive table th { white-space: normal; } "
    + ".rst-content img:not([src*='page.png']) { width: auto; height: auto; max-height: 34em; }</style>");
  $(".rst-content table").addClass("docutils").wrap('<div class="wy-table-responsive"></div>');
});
""",
}
FORMULAS = """document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".arithmatex")) {
    const text = place.textContent.trim();
    katex.render(text.slice(2, -2), place, {displayMode: text.startsWith("\\\\["), throwOnError: false});
  }
});
"""


def effect_pages():
    """Folder that `pendular effects --manual` wrote; None: the site has no page for each effect."""
    folder = os.environ.get("PENDULAR_EFFECT_PAGES")
    return folder if folder and os.path.isdir(folder) else None


def has_katex():
    return os.path.isfile(f"{KATEX}/katex.min.js")


def page_of_notebook(file, folder):
    """Writes a notebook as a page of Markdown with its pictures, and returns their names."""
    name = os.path.splitext(os.path.basename(file))[0]
    with open(file, encoding="utf-8") as opened:
        cells = json.load(opened)["cells"]
    parts, written = [], []
    for cell in cells:
        source = "".join(cell["source"])
        parts.append(source if cell["cell_type"] == "markdown" else f"```python\n{source}\n```")
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if "image/png" in data:
                written.append(f"{name}_{len(written) + 1}.png")
                with open(os.path.join(folder, written[-1]), "wb") as picture:
                    picture.write(base64.b64decode(data["image/png"]))
                parts.append(f"![Figure of the cell above]({written[-1]})")
            elif "text/html" in data:
                parts.append("".join(data["text/html"]))
            elif "text/plain" in data or "text" in output:
                parts.append("```text\n" + "".join(data.get("text/plain", output.get("text", ""))) + "\n```")
    written.append(name + ".md")
    with open(os.path.join(folder, written[-1]), "w", encoding="utf-8") as page:
        page.write("\n\n".join(parts) + "\n")
    return written


def on_config(config):
    if not has_katex():  # formulas then stay as TeX
        config["extra_css"], config["extra_javascript"] = [], []
    if effect_pages():
        reference = next(part["Reference"] for part in config["nav"] if "Reference" in part)
        reference.insert(3, {"Effects one by one": "effects/index.md"})
    return config


def on_files(files, config):
    def take(path, source):
        file = File(path, ROOT, config["site_dir"], config["use_directory_urls"])
        file.abs_src_path = source
        files.append(file)

    for path, source in BESIDE.items():
        take(path, os.path.join(ROOT, source))
    folder = effect_pages()
    for where, _, names in os.walk(folder) if folder else []:
        for name in names:
            inside = os.path.relpath(os.path.join(where, name), folder)
            take("effects/" + inside.replace(os.sep, "/"), os.path.join(folder, inside))
    pages = tempfile.mkdtemp(prefix="pendular-notebooks-")
    for name in sorted(os.listdir(os.path.join(ROOT, "docs", "notebooks"))):
        for written in page_of_notebook(os.path.join(ROOT, "docs", "notebooks", name), pages):
            take("notebooks/" + written, os.path.join(pages, written))
    files.remove(files.get_file_from_path("Doxyfile"))
    return files


def source_of(page_path):
    """Path of a page's file from the root of the project."""
    if page_path.startswith("effects/"):
        return page_path
    return BESIDE.get(page_path, "docs/" + page_path)


def place_of(source):
    """Path in the site of a file of the project; None: it is not in the site."""
    for path, beside in BESIDE.items():
        if source == beside:
            return path
    if source.startswith("docs/") and os.path.isfile(os.path.join(ROOT, source)):
        return re.sub(r"\.ipynb$", ".md", source[len("docs/"):])
    return None


def on_page_markdown(markdown, page, config, files):
    """Links of the project are made links of the site; what is not in the site is named by its path."""
    path = page.file.src_uri
    if path.startswith("effects/"):
        return markdown
    folder = posixpath.dirname(source_of(path))

    def link(match):
        text, target, anchor = match.group(1), match.group(2), match.group(3) or ""
        source = posixpath.normpath(posixpath.join(folder, target))
        place = place_of(source)
        if place:
            return f"[{text}]({posixpath.relpath(place, posixpath.dirname(path) or '.')}{anchor})"
        if not os.path.exists(os.path.join(ROOT, source)):
            log.warning("%s: '%s' does not exist", path, target)
        bare = text.strip("`")
        return f"`{source}`" if bare in source else f"{text} (`{source}`)"

    return re.sub(r"(?<!\!)\[([^\]]+)\]\((?!https?:|#|mailto:)([^)#\s]+)(#[^)]*)?\)", link,
                  re.sub(r"!\[([^\]]*)\]\(docs/", r"![\1](", markdown))


def on_nav(nav, config, files):
    listed = {page.file.src_uri for page in nav.pages}
    for file in files.documentation_pages():
        if file.src_uri not in listed and not file.src_uri.startswith("effects/"):
            log.warning("%s is not in the navigation of mkdocs.yml", file.src_uri)
    return nav


def complete_theme(folder):
    for name, content in MISSING.items():
        there = os.path.join(folder, name)
        if os.path.exists(there):
            continue
        if os.path.isfile(content):
            shutil.copy(content, there)
        else:
            with open(there, "w", encoding="utf-8") as file:
                file.write(content)


def index_as_script(folder):
    """Writes the index of words as a script too, for pages that are opened from the disk."""
    with open(os.path.join(folder, "search_index.json"), encoding="utf-8") as file:
        index = file.read()
    with open(os.path.join(folder, "search_index.js"), "w", encoding="utf-8") as file:
        file.write(f"window.search_index = {index};\n")


def on_post_build(config):
    complete_theme(os.path.join(config["site_dir"], "js"))
    index_as_script(os.path.join(config["site_dir"], "search"))
    if not has_katex():
        return
    there = os.path.join(config["site_dir"], "katex")
    os.makedirs(os.path.join(there, "fonts"), exist_ok=True)
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copy(f"{KATEX}/{name}", there)
    for name in os.listdir(f"{KATEX}/fonts"):
        shutil.copy(f"{KATEX}/fonts/{name}", os.path.join(there, "fonts"))
    with open(os.path.join(there, "formulas.js"), "w", encoding="utf-8") as file:
        file.write(FORMULAS)
