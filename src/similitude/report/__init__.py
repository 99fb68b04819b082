"""What a Run looks like to people and to other programs.

`summary` the JSON object · `table` the Parquet file · `plot` the picture · `terminal` the page on the
terminal · `html_report` the page for a browser (`html_page` makes any) · `files` all of them in one
folder, complete or not at all.  Nothing here computes physics.
"""
