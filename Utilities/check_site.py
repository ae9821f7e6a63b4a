"""Follows every link of the built site that stays within it, and refuses what would be asked of the network: check_site.py FOLDER."""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.loaded = [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for name in ("id", "name"):
            if values.get(name):
                self.anchors.add(values[name])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        # What a browser fetches by itself.
        if tag in ("script", "img", "iframe") and values.get("src"):
            self.loaded.append(values["src"])
        if tag == "link" and values.get("href") and values.get("rel") != "canonical":
            self.loaded.append(values["href"])


def main(site):
    pages = {path: Page(path.read_text(errors="replace")) for path in site.rglob("*.html")}
    problems, followed, outside = [], 0, set()
    for path, page in pages.items():
        # Doxygen's pages link one another by scripts; those of the site are followed from here into them.
        own = "cpp" not in path.relative_to(site).parts
        for link in page.links + page.loaded:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                if url.scheme not in ("data", "javascript", "mailto"):
                    outside.add(link)
                    if link in page.loaded:
                        problems.append(f"{path.relative_to(site)}: loads {link} from the network")
                continue
            if not own or link.startswith("#") and len(link) == 1:
                continue
            target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
            followed += 1
            if not target.exists():
                problems.append(f"{path.relative_to(site)}: {link} leads nowhere")
            elif url.fragment and target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors:
                problems.append(f"{path.relative_to(site)}: {link} has no such heading")
    print("\n".join(sorted(set(problems))))
    print(f"{len(pages)} pages, {followed} links followed, {len(outside)} lead outside, {len(set(problems))} problems")
    return 1 if problems or not followed else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
