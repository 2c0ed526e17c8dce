### Nápověda příkazové řádky, česky. Anglicky je v komentářích u příkazů; help.rs říká, co je co.

## Slova, která má clap jen anglicky

help-word-usage = Použití:
help-word-commands = Příkazy:
help-word-arguments = Argumenty:
help-word-options = Volby:
help-word-any-options = [VOLBY]
help-word-any-command = [PŘÍKAZ]
help-word-command = <PŘÍKAZ>
help-word-default = [výchozí:
help-word-values = [možnosti:
help-word-values-below = Možnosti:
help-word-help-command = Vypíše tuto nápovědu nebo nápovědu k příkazu
help-word-help-of-commands = Příkaz, ke kterému se má vypsat nápověda
help-word-help-more = Vypíše nápovědu (podrobnější vypíše --help)
help-word-help-less = Vypíše nápovědu (stručnou vypíše -h)
help-word-help = Vypíše nápovědu
help-word-version = Vypíše verzi

## Skupiny voleb

help-heading-files = Soubory a nastavení
help-heading-choice = Výběr nálezů
help-heading-picture = Obrázek
help-heading-frames = Snímky
help-heading-accuracy = Přesnost a čas
help-heading-reports = Zprávy
help-heading-machines = Více počítačů
help-heading-limits = Meze
help-heading-questions = Otázky
help-heading-global = Společné volby

## Oddíly stránek manuálu

help-section-name = JMÉNO
help-section-synopsis = POUŽITÍ
help-section-description = POPIS
help-section-options = VOLBY
help-section-commands = PŘÍKAZY
help-section-notes = POZNÁMKY

## Co mají všechny příkazy

help-any-color = Kdy používat barvy
    .value = KDY
    .auto = na terminálu a kde je nastaveno FORCE_COLOR nebo CLICOLOR_FORCE, není-li nastaveno NO_COLOR
    .always = vždy
    .never = nikdy
help-any-lang = Jazyk zpráv [výchozí: podle LC_ALL, LC_MESSAGES nebo LANG]
    .value = JAZYK
    .en = anglicky
    .cs = česky
help-any-quiet = Vypíše jen nálezy, odpovědi a chyby

## Co má více příkazů

help-any-file = Scéna jako záznamy nebo JSON; `-` je standardní vstup
    .value = SOUBOR
help-any-allowed = Kolik paměti smí příkaz nejvýše zabrat, například 800M nebo 12G; co by potřebovalo víc, odmítne [výchozí: polovina dostupné paměti]
    .value = KOLIK
help-any-paths = Soubory nebo složky se scénami [výchozí: .]; `-` je standardní vstup
    .value = CESTA
help-any-config = Soubor s nastavením místo všech souborů zpg.toml, nebo jedno nastavení, které má přednost před soubory, například `lint.W310=off`
    .value = SOUBOR|KLÍČ=HODNOTA
help-any-exclude = Vynechá soubory a složky, které odpovídají tomuto vzoru; co vynechávají nastavení, pak neplatí
    .value = VZOR
help-any-isolated = Nečte žádný soubor zpg.toml
help-any-force_exclude = Vynechá, co vylučuje nastavení, i když je to výslovně uvedeno jako CESTA
help-any-camera = Kamera, kterou se má obrázek pořídit
    .value = ID
help-any-view = Dívá se na scénu z této strany, ať má jakékoli kamery
    .value = STRANA
    .front = podél −z
    .back = podél +z
    .left = podél +x
    .right = podél −x
    .top = podél −y
    .bottom = podél +y
    .iso = zprava, zepředu a shora stejně
help-any-json = Vypíše odpověď jako JSON

## zpg

help-zpg = Nástroje pro scény v jazyce ZPG
    .after =
        Návratový kód: 0 znamená hotovo a bez chyb; 1 scéna má chyby, nebo odpověď zní „ne“; 2 příkaz je špatně zadán,
        nebo soubor nelze přečíst, nelze zapsat či není scénou.

        Příklady:
          zpg new scena.zpg         scéna, se kterou lze začít
          zpg check scena.zpg       co je ve scéně špatně
          zpg fmt scena.zpg         jeden záznam na řádek, čísla v co nejkratším zápisu
          zpg render scena.zpg      obrázek, scena.png
          zpg plan scena.zpg        které efekty obrázek potřebuje a proč
          zpg accuracy scena.zpg    kolik času stojí přesnost
          zpg convert scena.zpg --to pov -o scena.pov
          zpg crosscheck scena.zpg --with povray
          zpg sheet obrazky -o prehled.html
          zpg probe scena.zpg --ray "0 0 9  0 0 -1"
          zpg explain E101          co nález znamená a jak chybu opravit
          zpg explain koule         co typ záznamu znamená a jak se zapisuje

## zpg new

help-new = Zapíše scénu, se kterou lze začít
    .after =
        Scéna má nejvýše dvacet řádků s komentáři v jazyce zpráv. Projde příkazy `zpg check` a `zpg fmt --check` a
        `zpg render` ji vykreslí. Soubor, který už existuje, zůstane, jak je.

        Příklady:
          zpg new scena.zpg
          zpg new okno.zpg --from glass
          zpg new - --from bracket | zpg render - -o konzola.png
help-new-file = Soubor scény, který končí na .zpg; `-` je standardní výstup
    .value = SOUBOR
help-new-from = Co je na scéně; není-li zadáno, zrcadlo, prsten a koule
    .value = PŘEDLOHA
    .glass = sklo a jantar na šachovnici, prosvícené světlem
    .bracket = strojní součást: tělesa spojená a odečtená
    .chessboard = dva pěšci, rotační tělesa, na leštěné desce
    .stereo = dva prsteny a zrcadlo pro dvojici kamer
help-new-force = Přepíše soubor, který už existuje

## zpg check

help-check = Hledá ve scénách chyby
    .after =
        Nálezy se vypisují na standardní výstup. Návratový kód je 0, když ve scénách není žádná chyba, 1, když v nich
        nějaká je (nebo když --diff ukáže změnu), a 2, když soubor nelze přečíst, nelze zapsat nebo není scénou. Do
        souboru, který není scénou, se nikdy nic nezapíše.

        KÓD je kód nálezu (W307), jeho název (overlapping-union), začátek kódů (W3), nebo jedno ze slov warnings,
        notes, style a all. Pro celou složku scén se úrovně nálezů nastavují v zpg.toml; komentář
        `# zpg: allow(W307) #` povolí nález v místě, kde stojí. Z voleb --select, --extend-select, --ignore a --deny
        má přednost ta, která uvádí méně kódů. Chyby jazyka se hlásí vždy.

        Scénu v JSON (SOUBOR.json) lze zkontrolovat stejně jako scénu ze záznamů, ale ne s --fix, --diff a --add-allow.

        Nastavení ze zpg.toml lze zadat i volbou --config. Klíč `exclude` vynechává soubory a složky nalezené při
        procházení složek, klíč `per-file-ignores` vynechává v některých souborech některé kódy.

        Příklady:
          zpg check                            všechny *.zpg v této složce a jejích podsložkách
          zpg check scena.zpg
          zpg check sceny/                     všechny *.zpg ve složce kromě těch z .gitignore
          zpg check --fix scena.zpg            opraví, co lze opravit bezpečně
          zpg check --add-allow sceny/         zbývající nálezy povolí komentáři
          zpg check --diff scena.zpg           ukáže, co by --fix změnil
          zpg check --deny warnings sceny/     pro průběžnou integraci
          zpg check --format short sceny/      jeden řádek na nález
          zpg check --format json - < scena.zpg
          zpg check --format sarif --output-file zpg.sarif sceny/
          zpg check --isolated --config lint.W310=off sceny/

        Podrobnosti o nálezu vypíše `zpg explain E101`.
help-check-format = Jak nálezy vypsat
    .value = FORMÁT
    .human = s citací řádků, s poznámkami a s návrhy oprav
    .short = jeden řádek na nález
    .json = pro programy
    .sarif = pro přehledy nálezů v kódu: SARIF 2.1.0
    .github = pro GitHub Actions: poznámky přímo u změn
    .gitlab = pro GitLab: zpráva Code Quality (JSON) k žádosti o začlenění
    .junit = pro přehledy výsledků testů: JUnit XML
help-check-output_file = Zapíše nálezy do souboru místo na standardní výstup
    .value = SOUBOR
help-check-exit_zero = Skončí s návratovým kódem 0, i když jsou ve scénách chyby; kód 2 zůstává
help-check-show_files = Vypíše soubory, které by se kontrolovaly
help-check-show_settings = Vypíše nastavení, které platí pro první soubor, v podobě pro zpg.toml
help-check-fix = Opraví v souborech, co lze opravit bezpečně; scénu ze standardního vstupu vypíše na standardní výstup
help-check-force = S --fix nebo --add-allow: změní i soubory, jejichž jména mají příponu jiných programů (.csv, .md, .obj …)
help-check-add_allow = Doplní komentáře, které povolí všechny zbývající nálezy; chyby povolit nelze
help-check-unsafe_fixes = S --fix nebo --diff: použije i opravy, které jsou jen odhadem
help-check-diff = Nic nezapíše, jen ukáže, co by změnila volba --fix
help-check-select = Hlásí jen tyto kódy (a chyby)
    .value = KÓD
help-check-extend_select = Hlásí i tyto kódy, i když je nastavení vypínají
    .value = KÓD
help-check-ignore = Tyto kódy nehlásí
    .value = KÓD
help-check-deny = Hlásí tyto kódy jako chyby
    .value = KÓD
help-check-statistics = Místo nálezů vypíše, kolik jich je od každého kódu (jako text nebo JSON)
help-check-stdin_filename = Jméno souboru, za který se má standardní vstup považovat: ve zprávách, při hledání zpg.toml a obrázků; bez CESTY se čte standardní vstup
    .value = JMÉNO
help-check-watch = Po každé změně souboru zkontroluje znovu

## zpg fmt

help-fmt = Zformátuje scény: jeden záznam na řádek, čísla a komentáře zarovnané pod sebou
    .after =
        Soubory se přepisují na místě; s `-` se zformátuje standardní vstup na standardní výstup. Řádky s chybami,
        kódování a konce řádků se nemění. S --check nebo --diff se nic nezapisuje a návratový kód je 1, pokud by se něco
        změnilo. Do souboru, který není scénou, se nikdy nic nezapíše; návratový kód je pak 2.

        Styl se nastavuje v souboru zpg.toml (platí ten, který je od složky scény směrem nahoru nejblíž) nebo volbou
        --config. Klíč `exclude` vynechává soubory a složky. Výchozí styl je:
          {"["}format]
          width = 100                    šířka, na které se lámou profily a po kterou sahá zarovnání
          align = true                   čísla a komentáře sousedních řádků jsou pod sebou
          group = true                   vektory jednoho záznamu jsou odděleny dvěma mezerami
          numbers = "shortest"           co nejkratší zápis čísel; "keep" je ponechá, jak jsou

        Příklady:
          zpg fmt                        všechny *.zpg v této složce a jejích podsložkách
          zpg fmt scena.zpg
          zpg fmt sceny/                 všechny *.zpg ve složce kromě těch z .gitignore
          zpg fmt --diff scena.zpg       co by se změnilo
          zpg fmt --check sceny/         pro průběžnou integraci
          zpg fmt --range 3-9 scena.zpg  jen řádky 3 až 9
          zpg fmt - < vstup.zpg > vystup.zpg
help-fmt-check = Nic nezapíše, jen vyjmenuje soubory, které by se změnily
help-fmt-diff = Nic nezapíše, jen ukáže, co by se změnilo
help-fmt-force = Zformátuje i soubory, jejichž jména mají příponu jiných programů (.csv, .md, .obj …)
help-fmt-range = Změní jen záznamy, které zasahují do těchto řádků (počítáno od 1); jen pro jeden soubor
    .value = OD-DO
help-fmt-stdin_filename = Jméno souboru, za který se má standardní vstup považovat: ve zprávách a při hledání zpg.toml; bez CESTY se čte standardní vstup
    .value = JMÉNO

## zpg convert

help-convert = Převede scénu pro jiný program
    .after =
        Každý převod vypíše nakonec na chybový výstup zprávu: co ze scény je převedeno jen přibližně a o kolik se to
        liší, co je vynecháno a kolik vlastností je převedeno přesně. S --verbose vyjmenuje i ty přesné.

        Příklady:
          zpg convert scena.zpg -o scena.pov
          zpg convert scena.zpg -o scena.xml
          zpg convert scena.zpg -o scena.glb --tolerance 0.01
          zpg convert scena.zpg --to stl -o - | gzip > scena.stl.gz
          zpg convert scena.zpg --to json | jq .nodes
          zpg convert vytvorena-programem.json --to zpg
help-convert-to = Do čeho scénu převést; bez této volby to určí přípona za -o
    .value = CÍL
    .pov = POV-Ray 3.7, jeden soubor
    .mitsuba = Mitsuba 3: XML a vedle něj sítě
    .ply = trojúhelníky: Stanford PLY, binární, s barvami
    .obj = trojúhelníky: Wavefront OBJ a vedle něj knihovna materiálů
    .glb = trojúhelníky: glTF 2.0, binární
    .stl = trojúhelníky: STL, binární, pro 3D tisk
    .json = vyhodnocená scéna pro jiné programy
    .zpg = vyhodnocená scéna jako záznamy
help-convert-output = Kam převod zapsat; `-` je standardní výstup. Bez této volby jde na standardní výstup, síť do souboru SCÉNA.ply (obj, glb, stl) v aktuální složce. Z dvojice kamer vzniknou soubory JMÉNO_left a JMÉNO_right, na standardním výstupu jeden soubor s přepínačem. K souboru JMÉNO.obj patří JMÉNO.mtl a obrázky textur JMÉNO_texture_N.png; k souboru JMÉNO.xml takové obrázky a sítě JMÉNO_1.ply a další; k souboru JMÉNO.pov obrázky scény JMÉNO_image_N.png. Ve jménech vedle .obj a .pov se nahradí, co není písmeno bez diakritiky, číslice, -, _ ani tečka
    .value = SOUBOR
help-convert-force = Přepíše scénou (--to zpg) i soubor, který už existuje
help-convert-size = Velikost obrázku, pro který se převádí kamera, v pixelech
    .value = ŠxV
help-convert-depth = Kolikrát se smí paprsek odrazit nebo lomit
    .value = N
help-convert-tolerance = O kolik se smějí sítě odchýlit od zakřivených ploch, v jednotkách scény; výchozí je tisícina velikosti scény
    .value = DÉLKA
help-convert-verbose = Vyjmenuje i vlastnosti, které jsou převedeny přesně
help-convert-report = Zapíše zprávu o věrnosti převodu také jako JSON; `-` je standardní výstup
    .value = SOUBOR.json

## zpg sheet

help-sheet = Sestaví ze všech obrázků ve složce jeden přehled
    .after =
        Přehled ukazuje každý obrázek ze složky SLOŽKA a jejích podsložek (.png, .jpg, .webp, .exr, .pfm) s jeho jménem
        a velikostí, seřazené podle jmen. Pixel náhledu je průměr toho, co pokrývá, v lineárním světle; malé obrázky se
        nezvětšují. Skryté soubory a dřívější přehledy se vynechávají.

        Je-li ve složce soubor findings.json, který zapisuje `zpg check --format json`, uvádí se u každého obrázku počet
        chyb a varování scény stejného jména a na stránce HTML i samotné nálezy. Scéna bez obrázku má vlastní rámeček.
        Obrázek patří ke scéně ve stejné podsložce nebo k jediné scéně svého jména. JMÉNO_left, JMÉNO_right a JMÉNO.0001
        patří ke scéně JMÉNO.

        Obrázek, který nelze přečíst, má rámeček s důvodem. Návratový kód je pak 2, jinak 0; nálezy ho nemění.

        Příklady:
          zpg sheet obrazky -o prehled.png
          zpg sheet obrazky -o prehled.html --size 320x240
          zpg render odevzdane/ -o obrazky/
          zpg check --format json odevzdane/ > obrazky/findings.json
          zpg sheet obrazky -o prehled.html   co kdo nakreslil a s jakými chybami
help-sheet-folder = Složka s obrázky
    .value = SLOŽKA
help-sheet-output = Přehled: obrázek (.png) nebo stránka (.html); `-` je PNG na standardním výstupu
    .value = SOUBOR
help-sheet-columns = Kolik obrázků nejvýše je v řádku [výchozí: kolik se hodí]
    .value = N
help-sheet-size = Největší velikost náhledu v pixelech, od 32x32 do 1024x1024
    .value = ŠxV

## zpg crosscheck

help-crosscheck = Porovná, co ve scéně vidí zpg a co jiný program
    .after =
        Scéna se převede pro druhý program a to, co vidí, se porovná pixel po pixelu s tím, co vidí zpg. Liší-li se mimo
        obrysy a jiné hrany více než 0,05 % pixelů, odpověď zní „ne“ a návratový kód je 1.

        povray: porovnávají se obrázky v lineárním světle. Kde středem pixelu prochází hrana, rozhoduje o jediném vzorku
        zaokrouhlení. Je-li vedle vidět jiný objekt, je to obrys, jinak hrana stěny, stínu, vzoru nebo toho, co je vidět
        v zrcadle nebo ve skle. Úplný odraz počítá POV-Ray jinak. Všechno to se uvádí zvlášť.
        mitsuba: porovnává se poloha, normála a tvar toho, co je vidět jako první. Potřebuje Python s balíčkem mitsuba.
        Zvlášť se uvádějí pixely, které nerozliší jednoduchá přesnost, a pixely, ve kterých je náhoda, která ze dvou
        ploch na jednom místě je vidět. Je-li jich více než pixelů, které jsou vidět stejně, odpověď zní také „ne“.

        Do složky SLOŽKA se zapíšou obrázky ours.png, theirs.png, difference.png a side-by-side.png, čísla
        crosscheck.json a převedená scéna; u dvojice kamer se ke jménům přidá _left a _right. Barvy v difference.png:
        zelená je shoda, červená rozdíl, šedá obrysy (u povray jen ty, které se liší), žlutá jiné hrany, které se liší,
        modrá ostatní, co se uvádí zvlášť. V side-by-side.png jsou všechny tři s popisky.
        Obrázky z mitsuba znázorňují normály barvami, u těles směrem ven.

        Neporovnaly-li se všechny pixely, odpověď uvádí, kolik procent se jich porovnalo.

        Příklady:
          zpg crosscheck scena.zpg --with povray
          zpg crosscheck scena.zpg --with povray --size 320x240 -o srovnani --max-diff 1
          zpg crosscheck scena.zpg --with mitsuba --program venv/bin/python
help-crosscheck-file = Scéna
    .value = SOUBOR
help-crosscheck-with = Program, se kterým se má porovnat
    .value = PROGRAM
    .povray = POV-Ray 3.7
    .mitsuba = Mitsuba 3
help-crosscheck-size = Velikost obrázků v pixelech; celkem nejvýše 16777216 pixelů
    .value = ŠxV
help-crosscheck-output = Složka pro obrázky a čísla; výchozí je SCÉNA-povray nebo SCÉNA-mitsuba
    .value = SLOŽKA
help-crosscheck-max_diff = povray: o kolik se smí lišit kanál pixelu, v jednotkách 1/255 bílé
    .value = N
help-crosscheck-depth = povray: kolikrát se smí paprsek odrazit nebo lomit
    .value = N
help-crosscheck-tolerance = mitsuba: o kolik se smějí sítě odchýlit od zakřivených ploch, jako u convert
    .value = DÉLKA
help-crosscheck-program = Cesta k programu, pokud se nenajde podle jména (povray nebo python3)
    .value = CESTA
help-crosscheck-timeout = Jak dlouho smí jeden běh programu trvat: 90s, 2m, 1h; sklo, které rozkládá barvy, potřebuje tři běhy
    .value = ČAS
help-crosscheck-json = Vypíše čísla jako JSON

## Co mají příkazy, které popisují obrázek (render a farm)

help-any-size = Šířka a výška v pixelech
    .value = ŠxV
help-any-quality = Jak hladké budou hrany [výchozí: draft]
    .value = KVALITA
    .draft = jeden vzorek v každém pixelu
    .good = --adaptive 0.05: asi desetinásobek času, čtvrtina chyby
    .final = --adaptive 0.01: asi dvacetinásobek času, desetina chyby
help-any-samples = Počet vzorků v každém pixelu; jeden leží v jeho středu
    .value = N
help-any-adaptive = Přidává vzorky, nejvýše do 1024, dokud odhad chyby pixelu v lineárním RGB neklesne pod tuto mez
    .value = MEZ
help-any-exposure = Kolikrát obrázek zesvětlit
    .value = KOLIKRÁT
help-any-depth = Kolikrát se smí paprsek odrazit nebo lomit
    .value = N
help-any-cutoff = Zanedbá paprsky, které váží méně než toto číslo; 0 nezanedbá nic [výchozí: 1/4096]
    .value = VÁHA
help-any-precision = Čísla, kterými se počítá od paprsku k tomu, co zasáhne
    .value = ČÍSLA
    .f32 = jednoduchá přesnost bez ověřování
    .f64 = dvojitá přesnost; co nerozhodne, rozhodne dd
    .dd = double-double, dvojice čísel dvojité přesnosti, asi 32 číslic
help-any-crop = Vykreslí jen tuto část obrázku
    .value = X,Y,Š,V
help-any-stereo = Jak zapsat oba obrázky z dvojice kamer [výchozí: pair]
    .value = JAK
    .pair = dva soubory, JMÉNO_left a JMÉNO_right
    .side-by-side = jeden obrázek, levý vedle pravého
    .anaglyph = jeden obrázek pro červeno-azurové brýle
help-any-frames = Vykreslí obrázek pro každý z těchto snímků, například 0-47: JMÉNO.0000.png a tak dále, nebo jeden .apng. Jediné číslo znamená jen tento snímek
    .value = A-B
help-any-set = Mění číslo od prvního snímku k poslednímu, například `9.fovy=30..60`, `5.x[3]=1..2` nebo `5@7.x=0..4`, kde 7 je řádek; jména vypíše `zpg explain`
    .value = ID.PARAMETR=OD..DO
help-any-frames_from = Vezme čísla z tabulky: sloupec pro každé číslo, se jménem v prvním řádku, a řádek pro každý snímek
    .value = TABULKA.csv
help-any-orbit = Otáčí kamerou, nebo oběma kamerami dvojice, kolem toho, na co se dívá; 360 stupňů dá smyčku
    .value = ID,STUPNĚ
help-any-only = Vykreslí jen tyto snímky
    .value = I-J
help-any-fps = Počet snímků za sekundu v .apng [výchozí: 25]
    .value = N

## zpg render

help-render = Vykreslí scény
    .after =
        Bez -o se obrázek scény SCÉNA.zpg zapíše do souboru SCÉNA.png v aktuální složce. PNG, WebP
        (bezztrátový) a JPEG jsou osmibitové sRGB, EXR a PFM obsahují lineární neoříznutá 32bitová čísla. Na standardní
        výstup se vypíše, co bylo zapsáno; s `-o -` tam jde jen samo PNG. Co je s obrázkem v nepořádku, například že v záběru
        nic není, se vypíše na chybový výstup. Scéna s výběrem dvojice kamer dá dva obrázky, SCÉNA_left.png
        a SCÉNA_right.png, pokud --stereo neurčí jinak. Obrázky několika scén nebo scén ze složky se zapíšou do složky,
        kterou určuje -o. Snímky se zapíšou do souborů JMÉNO.0000.png a tak dále; každý je obrázkem scény, do níž jsou
        zapsána jeho čísla. Po přerušení (Ctrl-C) zůstanou vykreslené řádky v souboru JMÉNO.part.exr vedle obrázku
        a ostatní vykreslí --resume.

        Příklady:
          zpg render scena.zpg
          zpg render scena.zpg -o velky.png --size 1920x1080 --quality good
          zpg render scena.zpg --view top --watch
          zpg render sceny -o obrazky
          zpg render scena.zpg -o film.exr --adaptive 0.01
          zpg render scena.zpg -o scena.jpg --exposure 0.7
          zpg render scena.zpg -o oblet.png --frames 0-99 --orbit 9,360
          zpg render scena.zpg -o zoom.apng --frames 0-24 --set 9.fovy=60..20
          zpg render scena.zpg --cost
          zpg render scena.zpg --crop 200,100,64,64 --stats naklady.json
          zpg render scena.zpg -o 3z8.png --tile 3/8
help-render-paths = Scény jako záznamy nebo JSON, nebo složky se scénami; `-` je standardní vstup
    .value = CESTA
help-render-output = Kam obrázek zapsat: .png, .jpg, .webp, .exr nebo .pfm; `-` je standardní výstup. Nebo složka, nebo .apng ze snímků
    .value = VÝSTUP
help-render-watch = Kreslí znovu, kdykoli se scéna nebo obrázek, který používá, změní
help-render-tile = Vykreslí jen tento díl, pás řádků, například 3/8 nebo 3-5/8; díly spojí `zpg join`
    .value = I/N
help-render-resume = Přeskočí, co už je vykresleno, a pokračuje v tom, co zbylo po přerušení
help-render-threads = Počet pracovních vláken; 0 znamená tolik, kolik je procesorů. Nejvýše čtyřikrát tolik
    .value = N
help-render-stats = Zapíše do souboru jako JSON, co vykreslení stálo: časy, paprsky, testy, práci jednotlivých efektů; `-` je standardní výstup
    .value = SOUBOR
help-render-cost = Vypíše, co vykreslení stálo: paprsky, čas, nejdražší objekty a efekty
help-render-heatmap = Zapíše mapu nákladů: v nepravých barvách, kolik testů průsečíků připadlo na každý pixel
    .value = VÝSTUP.png

## zpg farm

help-farm = Zapíše úlohu, která vykreslí obrázky na mnoha počítačích
    .after =
        Úloha je složka se scénami a jejich texturami, se skripty, které kreslí a spojují, s tím, co čte plánovač, a se
        souborem README, který říká, jak ji spustit. Nic v ní se netýká tohoto počítače. Velký obrázek se rozdělí na pásy
        řádků, tolik, aby každý na --cores procesorech trval asi --tile-time; zjistí to několik vteřin kreslení. Co je
        hotové, se nekreslí znovu, a obrázky mají tytéž bajty, jaké zapíše jeden počítač. Z několika scén se ty s chybami
        nevykreslí a na konci vznikne přehled všech obrázků s tím, co je ve scénách špatně. Všechny volby, které určují,
        jak obrázek vypadá, jsou volby příkazu `zpg render`.

        Příklady:
          zpg farm scena.zpg --size 8000x6000 --quality final -o uloha --for slurm
          zpg farm scena.zpg --frames 0-599 --orbit 9,360 -o uloha --for openjd
          zpg farm prace -o uloha --for shell
help-farm-paths = Scény jako záznamy nebo JSON, nebo složky se scénami
    .value = CESTA
help-farm-output = Složka úlohy; vytvoří se
    .value = ÚLOHA
help-farm-engine = Co úlohu spustí
    .value = PLÁNOVAČ
    .openjd = Open Job Description: job.yaml, pro renderovací farmy a `openjd run`
    .slurm = Slurm: pole úloh, které kreslí, a úloha, která spojuje
    .shell = make, na jednom počítači
help-farm-tiles = Počet pásů každého obrázku [výchozí: podle --tile-time]
    .value = N
help-farm-tile_time = Jak dlouho má trvat jedna dílčí úloha
    .value = ČAS
help-farm-cores = Počet procesorů dílčí úlohy
    .value = N
help-farm-format = Formát obrázků
    .value = FORMÁT
    .png = osmibitové sRGB
    .exr = lineární neoříznutá 32bitová čísla

## zpg join

help-join = Spojí části obrázku
    .after =
        Části jsou to, co zapisuje `zpg render --tile`. Obrázek má tytéž bajty, jaké by zapsal `zpg render` bez --tile.
        Části jiného obrázku, jiné verze zpg nebo s jinými volbami příkaz odmítne, stejně jako řádky, které chybějí nebo
        jsou tu dvakrát: návratový kód je pak 1 a nic se nezapíše ani nesmaže. Složka zastupuje soubory PNG a EXR v ní.
        Z částí PNG vznikne PNG, z částí EXR buď PNG, nebo EXR. Části se smažou, pokud není zadáno --keep; části EXR,
        ze kterých vzniklo PNG, zůstanou, protože je v nich víc.

        Příklady:
          zpg join dily/*.png -o scena.png
          zpg join dily -o scena.exr --keep
help-join-parts = Části nebo složky s nimi
    .value = ČÁST
help-join-output = Kam obrázek zapsat: .png nebo .exr
    .value = VÝSTUP
help-join-keep = Ponechá části na místě

## zpg probe

help-probe = Odpovídá na otázky o paprscích a bodech
    .after =
        Na každý paprsek vypíše jeden řádek s objektem JSON, v pořadí paprsků. Jsou v něm všechny průsečíky paprsku
        s hranicemi těles pro t > 0, vzestupně, jako by každá plocha paprsek propouštěla. Jednotkou t je délka směru.

        Soubor s paprsky má na každém řádku jeden paprsek, `ox oy oz dx dy dz`; mezi čísly mohou být čárky. Prázdné
        řádky a vše za znakem # se přeskočí. Není-li na řádku paprsek, nebo na jeho čísla zvolená přesnost nestačí,
        vypíše se na chybový výstup, co je špatně, a odpověď k řádku chybí. Ostatní řádky odpověď mají a návratový kód
        je 2. Na řádku delším než 65536 bajtů čtení souboru skončí.

        `shape` je ID záznamu, který plochu vytvořil, u kopie ID kopie. `object` je nejvyšší objekt nad ním, kterému byly
        přiřazeny vlastnosti, jinak totéž co `shape`. Normála míří ven z tělesa, i tam, kde hranice vznikla řezem. Co leží
        mimo kvádr renderovacího záznamu, se nevypíše, ale počítá se do `inside_at_origin`, tedy do stavu těsně za
        počátkem paprsku.

        --point vypíše ID těles (tvarů i operací), v nichž bod leží; hranice k tvarům patří. `in_scene` říká, zda bod leží
        ve vykreslovaném celku, a to uvnitř kvádru renderovacího záznamu. Počítá se ve dvojité přesnosti, a kde nestačí, v dd;
        volba --precision na to nemá vliv.

        Příklady:
          zpg probe scena.zpg --ray "0 0 9  0 0 -1"
          zpg probe scena.zpg --rays paprsky.txt > pruseciky.jsonl
          zpg probe scena.zpg --pixel 320,240 --size 640x480
          zpg probe scena.zpg --point "0 1 0" --object 4
help-probe-ray = Počátek a směr jednoho paprsku; mezi čísly mohou být čárky
    .value = OX OY OZ DX DY DZ
help-probe-rays = Soubor s paprsky; `-` je standardní vstup
    .value = SOUBOR
help-probe-pixel = Paprsek středem pixelu; pixely se počítají od 0 vlevo nahoře
    .value = X,Y
help-probe-point = Bod
    .value = X Y Z
help-probe-size = Šířka a výška obrázku, ke kterému patří --pixel
    .value = ŠxV
help-probe-object = Ptá se jen na tento objekt, v té podobě, jakou má na konci souboru; kvádr renderovacího záznamu se nebere v úvahu
    .value = ID
help-probe-precision = Čísla, kterými se počítá; u dd jsou t, body a normály texty o 32 číslicích. Na --point nemá vliv
    .value = ČÍSLA
    .f32 = { help-any-precision.f32 }
    .f64 = { help-any-precision.f64 }
    .dd = { help-any-precision.dd }

## zpg plan

help-plan = Vypíše, které efekty scéna potřebuje a proč
    .after =
        Efekt je zapnutý, jen když může být vidět. Nic nezapínají vlastnosti přepsané jinými, odečítaná tělesa,
        objekty, ke kterým se od renderovacího záznamu nelze dostat, ani části, které nemůže vidět žádný paprsek. Kód
        vypnutého efektu se neprovádí. Část není vidět, leží-li mimo kvádr renderovacího záznamu, nebo celá uvnitř
        neprůhledného tělesa, které nic neotevírá.

        Příklady:
          zpg plan scena.zpg
          zpg plan scena.zpg --json

## zpg accuracy

help-accuracy = Změří, co které nastavení přinese obrázku scény a kolik času stojí
    .after =
        Měří se čtyři druhy chyb: hrany (samples, adaptive), zanedbané světlo (depth, cutoff), zaokrouhlování (precision,
        solver) a plošky (tessellation, levels). Každý se měří proti referenci přesnější než vše, co se zkouší; ostatní
        nastavení jsou taková, jaká má prosté `zpg render`. Co scéna nepotřebuje, se neměří, a zpráva říká proč. Samotnou
        referenci ověřuje nezávislý sledovač paprsků, který počítá na 71 číslic.

        Z velkého obrázku se měří malé dlaždice, nikdy zmenšený obrázek. Každý čas je nejkratší čas procesoru
        na jednom vlákně z několika běhů v zamíchaném pořadí. Časy, které se liší o méně než naměřený šum, se neřadí.
        Do složky SLOŽKA se zapíšou accuracy.json, accuracy.md, accuracy.svg a accuracy.html. Po Ctrl-C se zapíše, co je
        hotovo.

        Příklady:
          zpg accuracy scena.zpg
          zpg accuracy scena.zpg --size 1920x1080 --budget 10m -o zprava
          zpg accuracy scena.zpg --axes samples,adaptive --goal 0.5
          zpg accuracy --shapes
help-accuracy-file = Scéna; `-` je standardní vstup
    .value = SOUBOR
help-accuracy-size = Šířka a výška obrázku v pixelech
    .value = ŠxV
help-accuracy-axes = Která nastavení zkoušet, oddělená čárkami [výchozí: všechna]
    .value = CO
help-accuracy-runs = Kolikrát se každé nastavení změří [výchozí: 5]
    .value = N
help-accuracy-budget = Kolik času má měření asi trvat: 90s, 2m, 1h [výchozí: 2m]
    .value = ČAS
help-accuracy-goal = Chyba, která ještě nevadí, v krocích osmibitového obrázku
    .value = KROKY
help-accuracy-output = Složka pro zprávu; výchozí je SCÉNA-accuracy
    .value = SLOŽKA
help-accuracy-shapes = Místo scény změří čas a chybu jednoho paprsku pro každý tvar, druh čísel a řešič
help-accuracy-json = Vypíše zprávu jako JSON

## zpg explain

help-explain = Vysvětlí nález nebo typ záznamu
    .after =
        Bez argumentu vypíše všechny kódy a typy záznamů.

        Příklady:
          zpg explain E101            nález podle kódu
          zpg explain undefined-id    … nebo podle názvu
          zpg explain W310 W305       několik nálezů
          zpg explain W3              seznam kódů, které tak začínají
          zpg explain -399            typ záznamu podle čísla
          zpg explain šachovnice      … nebo podle jména, českého či anglického
          zpg explain sklo            jak udělat sklo, zrcadlo, hranol, stín
help-explain-topic = Kód nebo název nálezu, číslo nebo jméno typu záznamu, o jednom slově nebo více
    .value = KÓD|TYP

## zpg lsp

help-lsp = Jazykový server: nálezy, nápověda, opravy a další přímo v editoru
    .after =
        Editory tento příkaz spouštějí samy a komunikují s ním přes jeho standardní vstup a výstup; jak který nastavit,
        říká docs/editors.md. Nastavení se čte ze zpg.toml stejně jako na příkazové řádce.

        Příklady:
          zpg lsp              co spouští editor
          zpg lsp --lang en    totéž s anglickými zprávami
help-lsp-stdio = Komunikuje přes standardní vstup a výstup, jako vždy; některé editory tuto volbu zadávají

## zpg completions

help-completions = Vypíše skript, který v shellu doplňuje příkazovou řádku zpg
    .after =
        Příklady:
          zpg completions bash > ~/.local/share/bash-completion/completions/zpg
          zpg completions fish > ~/.config/fish/completions/zpg.fish
          zpg completions zsh > ~/.zfunc/_zpg    kde ~/.zfunc je složka z $fpath
help-completions-shell = Shell
    .value = SHELL

## zpg man

help-man = Vypíše stránku manuálu o zpg nebo o některém příkazu
    .after =
        Příklady:
          zpg man render > zpg-render.1    stránka o zpg render, v jazyce zpráv
          man ./zpg-render.1               jak vypadá
help-man-about = Příkaz [výchozí: celé zpg]
    .value = PŘÍKAZ
