"""The documentation as a site: every file of docs/ is in the navigation, every link and anchor inside
of it leads somewhere, and no page asks the network for anything.
    python3 check_site.py PROGRAM PROJECT FOLDER
The site is written to FOLDER. Exit code 77: mkdocs is missing."""
import os, re, shutil, subprocess, sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

program, project, folder = map(os.path.abspath, sys.argv[1:4])
if not shutil.which("mkdocs") or not os.path.isdir("/usr/lib/python3/dist-packages/pymdownx"):
    print("mkdocs or python3-pymdownx is not installed")
    sys.exit(77)


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loads = set(), [], []
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.ids.add(found.get("id") or found.get("name"))
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
        if tag in ("script", "img", "iframe", "source") and found.get("src"):
            self.loads.append(found["src"])
        if tag == "link" and found.get("rel") != "canonical" and found.get("href"):
            self.loads.append(found["href"])


wrong = []
build = subprocess.run(["bash", "scripts/build_site.sh", program, folder], cwd=project, capture_output=True, text=True)
if build.returncode:
    sys.exit(build.stdout + build.stderr)
pages = {}
for where, _, names in os.walk(folder):
    for name in names:
        if name.endswith(".html") and name != "404.html":
            pages[os.path.join(where, name)] = Page(os.path.join(where, name))
for path, page in pages.items():
    name = os.path.relpath(path, folder)
    for target in page.links + page.loads:
        parts = urlsplit(target)
        if parts.scheme or parts.netloc:
            if target in page.loads:
                wrong.append(f"{name} loads {target} from the network")
            continue
        there = os.path.normpath(os.path.join(os.path.dirname(path), unquote(parts.path))) if parts.path else path
        if os.path.isdir(there):
            there = os.path.join(there, "index.html")
        if not os.path.exists(there):
            wrong.append(f"{name}: {target} leads nowhere")
        elif parts.fragment and there in pages and unquote(parts.fragment) not in pages[there].ids:
            wrong.append(f"{name}: {target} names no heading")
for where, _, names in os.walk(os.path.join(folder)):
    for name in names:
        if name.endswith(".css"):
            with open(os.path.join(where, name), encoding="utf-8") as file:
                wrong += [f"{name} loads {url}" for url in re.findall(r"url\(\s*['\"]?(https?://[^)]*)\)", file.read())]
# Every text of docs/ is there, and in the navigation of the first page.
listed = {unquote(urlsplit(link).path) for link in pages[os.path.join(folder, "index.html")].links}
for where, _, names in os.walk(os.path.join(project, "docs")):
    for name in names:
        page = os.path.relpath(os.path.join(where, name), os.path.join(project, "docs"))[:-3] + ".html"
        if name.endswith(".md") and page not in listed:
            wrong.append(f"{page} is not in the navigation")
if len(os.listdir(os.path.join(folder, "effects/figures"))) < 20:
    wrong.append("the pages of effects have no figures")
print("\n".join(wrong))
print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links")
sys.exit(1 if wrong or len(pages) < 30 else 0)
